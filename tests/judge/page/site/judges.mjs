/// @file
/// The judge: a chapter's specs as one instance, the student's module as another one beside it. In a
/// page judge.mjs gives it a Web Worker; it is the same in node.

import {Student} from './student.mjs';

/// What a judge calls while it asks (page_worker.cpp).
class Desk {
  judge = null; // its instance

  /// @param at told where the judge is: {case, question}, or null when an answer has come
  begin(module, hung, at) {
    Object.assign(this, {module, hung, at, broken: false});
    this.forget();
  }
  forget() { this.student = null; }

  answer(number, question) {
    if (this.hung.some(each => each.case === number && each.question === question))
      return {how: 'hung'};
    this.student ??= new Student(this.module, {
      wrote: (descriptor, bytes) => this.#wrote(descriptor, bytes),
      reads: most => this.#reads(most),
    });
    this.at({case: number, question});
    const ending = this.student.answer();
    this.at(null);
    return ending;
  }

  #wrote(descriptor, bytes) {
    return this.#lent(Math.max(1, bytes.length), place => {
      this.judge.HEAPU8.set(bytes, place);
      return this.judge._student_wrote(descriptor, place, bytes.length) === 1;
    });
  }

  #reads(most) {
    const size = Math.min(most, 1 << 20); // a frame is no longer
    return this.#lent(Math.max(1, size), place => {
      const got = this.judge._student_reads(place, size);
      return this.judge.HEAPU8.slice(place, place + got);
    });
  }

  /// Runs `work` with some of the judge's memory. A student's recursion may leave the judge no stack:
  /// then this instance of it is not used again.
  #lent(size, work) {
    const stack = this.judge.stackSave();
    try {
      const place = this.judge._malloc(size);
      const result = work(place);
      this.judge._free(place);
      return result;
    } catch (error) {
      this.judge.stackRestore(stack);
      this.broken = true;
      throw error;
    }
  }
}

/// The judge of a chapter.
export class ChapterJudge {
  #desk = new Desk();
  #judge;

  /// @param factory what judge_04.mjs exports
  /// @param wasm    judge_04.wasm, compiled
  static async start(factory, wasm) {
    const made = new ChapterJudge();
    made.#judge = made.#desk.judge = await factory({
      student: made.#desk,
      instantiateWasm: (imports, done) => {
        WebAssembly.instantiate(wasm, imports).then(instance => done(instance, wasm));
        return {};
      },
    });
    return made;
  }

  /// Whether it can be asked again.
  get isWhole() { return !this.#desk.broken; }

  /// [{id, number, chapter, name, title, signature, stub, hints}]
  describe() { return JSON.parse(this.#judge.ccall('describe_units', 'string', [], [])); }

  /// {numbers} or {outcome, detail}: what an engine says to a figure's numbers (page_figure.hpp)
  answerFigure(question, wasm, at) {
    this.#desk.begin(new WebAssembly.Module(wasm), [], at);
    const json = this.#judge.ccall('answer_figure', 'string', ['string'], [JSON.stringify(question)]);
    this.#desk.forget();
    return json;
  }

  /// {matrix, complete}: every spec against every misconception, as ./tumble matrix prints it
  killMatrix(seed) { return JSON.parse(this.#judge.ccall('kill_matrix', 'string', ['number'], [seed])); }

  /// @param request {unit, source, built, seed, seeds?, onlyCase?, hung?}: see README.md
  /// @param at      told which question is asked: {case, question}; null when it is answered
  /// @return the verdict as JSON: its fingerprints are larger than a number of JavaScript
  /// @throws Error if the request cannot be carried out
  judge(request, at = () => {}) {
    const {wasm, ...said} = request.built;
    const module = said.ok ? new WebAssembly.Module(wasm) : null;
    this.#desk.begin(module, request.hung ?? [], at);
    const {unit, source, seed, seeds = 1, onlyCase = 0} = request;
    const text = JSON.stringify({unit, source, built: said, seed, seeds, onlyCase});
    const json = this.#judge.ccall('judge_unit', 'string', ['string'], [text]);
    this.#desk.forget();
    const {failure} = JSON.parse(json);
    if (failure) throw new Error(failure);
    return json;
  }
}

/// Judges, with the chapters' judges that were started before.
export class Judges {
  #started = new Map();

  /// @param load (digits of a chapter, as "04") → Promise of {factory, wasm}
  constructor(load) { this.load = load; }

  async judgeUnit(request, at) {
    return (await this.#judgeOf(request.unit.slice(0, 2))).judge(request, at);
  }

  /// Any chapter's judge can ask: it is that of the page that the figure stands in.
  async answerFigure({digits, question, built}, at) {
    return (await this.#judgeOf(digits)).answerFigure(question, built.wasm, at);
  }

  async #judgeOf(digits) {
    let judge = this.#started.get(digits);
    if (!judge?.isWhole) {
      const {factory, wasm} = await this.load(digits);
      judge = await ChapterJudge.start(factory, wasm);
      this.#started.set(digits, judge);
    }
    return judge;
  }
}
