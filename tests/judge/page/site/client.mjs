// Judges in the page: a compiler and a judge, each in a Web Worker of its own.
import { units } from "./course.mjs";

const patience = 2000; // [ms] for one answer, as natively
const patienceWithCompiler = 30000; // [ms] for one file: a hundred times what an exercise takes
const patienceAhead = 10000; // [ms] for a file that nobody waits for

/** One worker, and what is being asked of it. */
class Asked {
  constructor(url) {
    this.worker = new Worker(url, { type: "module" });
    this.last = 0;
  }

  /**
   * The message that answers this one.
   * @param hear   is called with those before it
   * @param signal breaks it off
   */
  ask(message, hear, signal) {
    signal?.throwIfAborted();
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.fail = reject;
      signal?.addEventListener("abort", () => reject(signal.reason), { once: true });
      this.worker.onerror = (event) => reject(new Error(event.message || "a script of the page cannot be loaded"));
      this.worker.onmessage = ({ data }) => {
        if (data.id !== id) return;
        if (data.failure) reject(new Error(data.failure));
        else if ("built" in data || "verdict" in data) resolve(data);
        else hear(data);
      };
      this.worker.postMessage({ ...message, id });
    });
  }

  end() {
    this.worker.terminate();
  }
}

/** A question that has no answer in time. */
class Hung extends Error {
  constructor(at) {
    super("no answer in time");
    this.at = at;
  }
}

/** A file that keeps the compiler busy. */
class TooExpensive extends Error {
  /** @param patience  for so long the compiler was busy [ms] */
  constructor(patience) {
    super();
    this.built = { ok: false, step: "limit", output: "", headers: [], seconds: patience / 1000 };
  }
}

/** Rejects when the signal does. */
function brokenOff(signal) {
  return new Promise((_, reject) => signal?.addEventListener("abort", () => reject(signal.reason), { once: true }));
}

export class Judge {
  constructor(base = new URL("./", import.meta.url)) {
    this.base = base;
    this.queue = Promise.resolve();
    this.last = {};
  }

  /**
   * The verdict on a file: the object that `./tumble check --json` writes of a unit; its `json` is
   * that text.
   * @param unit       "04_quaternions/product"
   * @param seed       of the inputs
   * @param onProgress is called with {done, total} [bytes] while something is downloaded
   * @param onCompiling is called when the compiler is there, and begins
   * @param onHung     is called with the number of calls that have not come back in time
   * @param signal     ends it: an AbortSignal
   */
  check(unit, source, { seed, onProgress = () => {}, onCompiling = () => {}, onHung = () => {}, signal }) {
    this.ahead = null; // what has not begun gives way
    const began = performance.now(); // a reader waits for the turn, too
    const verdict = this.#inTurn(() => this.#check(unit, source, seed, began, { onProgress, onCompiling, onHung, signal }));
    return Promise.race([verdict, brokenOff(signal)]); // also while it waits for its turn
  }

  /**
   * Builds a file while its reader reads it over: a check of the same text has less to wait for. Only
   * the last text that was given is built; one that keeps the compiler busy is left to the check.
   */
  async buildAhead(unit, source) {
    const ahead = (this.ahead = { unit, source });
    await this.#inTurn(async () => {
      if (this.ahead === ahead) await this.#kept("unit", ahead, () => this.#build(ahead, {}, patienceAhead));
    }).catch(() => {}); // the check says what is wrong
  }

  #inTurn(work) {
    const result = this.queue.then(work);
    this.queue = result.catch(() => {}); // the next one has its own chance
    return result;
  }

  /**
   * What an engine of these files [{id, text}], and of solutions for what they lack, answers to a
   * figure: {numbers, own} or {outcome, detail}; own are the units that are the reader's.
   * @param digits   of the figure's chapter
   * @param topic    as student/figure_TOPIC.cpp
   * @param question numbers
   */
  answerFigure(digits, topic, question, files, onProgress = () => {}) {
    return this.#inTurn(() => this.#answerFigure(digits, { topic, files }, question, { onProgress }));
  }

  async #answerFigure(digits, engine, question, listeners) {
    const built = await this.#engineOf(engine, listeners);
    if (!built.ok) return { outcome: "they do not link", detail: built.output };
    try {
      const { verdict } = await this.#judge({ digits, question, built }, listeners);
      return { ...JSON.parse(verdict), own: built.own };
    } catch (failure) {
      if (!(failure instanceof Hung)) throw failure;
      return { outcome: "hung", detail: "a call has not come back in 2 s" };
    }
  }

  #engineOf(engine, listeners) {
    const patience = patienceWithCompiler * (engine.files.length + 1);
    return this.#kept("engine", engine, () => this.#build({ engine }, listeners, patience).catch((failure) => {
      if (failure instanceof TooExpensive) return failure;
      throw failure;
    }));
  }

  /** The last one of its kind, if it was built of the same; else what is built now. */
  async #kept(kind, what, build) {
    const key = JSON.stringify(what);
    if (this.last[kind]?.key !== key) this.last[kind] = { key, built: (await build()).built };
    return this.last[kind].built;
  }

  async #check(unit, source, seed, began, listeners) {
    const built = await this.#kept("unit", { unit, source }, () => this.#buildUnit(unit, source, listeners));
    if (built.step === "limit") this.last.unit = null; // the computer may have more time or memory later
    listeners.onCompiling(); // it may have been built before
    const hung = [];
    for (;;) {
      try {
        const waited = { ...built, seconds: (performance.now() - began) / 1000 }; // for all of it, as a reader does
        const { verdict } = await this.#judge({ unit, source, built: waited, seed, hung }, listeners);
        return { ...JSON.parse(verdict), json: verdict };
      } catch (failure) {
        if (!(failure instanceof Hung)) throw failure;
        hung.push(failure.at); // the same again, and this question has no answer
        listeners.onHung(hung.length);
      }
    }
  }

  /** What the compiler has made of a file. If that takes too long, the compiler is ended. */
  async #build(what, { onProgress, onCompiling, signal }, patience = patienceWithCompiler) {
    const compiler = (this.compiler ??= new Asked(new URL("compiler.mjs", this.base)));
    let clock;
    const hear = ({ progress, compiling }) => {
      if (progress) onProgress?.(progress);
      if (!compiling) return;
      clock = setTimeout(() => compiler.fail(new TooExpensive(patience)), patience);
      onCompiling?.();
    };
    try {
      return await compiler.ask(what, hear, signal);
    } catch (failure) {
      compiler.end();
      this.compiler = null;
      throw failure;
    } finally {
      clearTimeout(clock);
    }
  }

  /**
   * What the compiler has made of a student's file. Whether it is the file or this computer that takes
   * too long, the course's own text tells: it is built by a new compiler, and then the file once more,
   * with twenty times the time of that text.
   */
  async #buildUnit(unit, source, listeners) {
    try {
      return await this.#build({ unit, source }, listeners);
    } catch (failure) {
      if (!(failure instanceof TooExpensive)) throw failure;
    }
    const again = Math.max(patienceWithCompiler, 20 * (await this.#timeOfStub(unit, listeners)));
    try {
      return await this.#build({ unit, source }, listeners, again);
    } catch (failure) {
      if (failure instanceof TooExpensive) return failure;
      throw failure;
    }
  }

  /** How long the untouched exercise takes to build [ms]. */
  async #timeOfStub(unit, listeners) {
    const { stub } = (await units()).find(({ id }) => id === unit);
    try {
      const { built } = await this.#build({ unit, source: stub }, listeners, 4 * patienceWithCompiler);
      return 1000 * built.seconds;
    } catch (failure) {
      if (!(failure instanceof TooExpensive)) throw failure;
      throw new Error("this computer is too busy: the compiler does not finish the untouched exercise either");
    }
  }

  /** One run of a spec. A worker whose student does not answer in time is ended. */
  async #judge(message, { onProgress, signal }) {
    const judge = (this.judge ??= new Asked(new URL("judge.mjs", this.base)));
    let clock;
    const end = (why) => {
      judge.end();
      this.judge = null;
      judge.fail(why);
    };
    const hear = ({ at, progress }) => {
      if (progress) return onProgress(progress);
      clearTimeout(clock);
      if (at) clock = setTimeout(() => end(new Hung(at)), patience);
    };
    try {
      return await judge.ask(message, hear, signal);
    } catch (failure) {
      end(failure);
      throw failure;
    } finally {
      clearTimeout(clock);
    }
  }
}
