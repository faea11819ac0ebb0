// The box "Now write 4.1" with its editor: check, hints, reset, and the solution at the end.
import { element, inlineMarkdown } from "./element.mjs";
import { makeEditor } from "./editor.mjs";
import { Judging } from "./judging.mjs";
import { contractText, foldCommand } from "./task.mjs";
import { onWorkOfOthers, replaceText, saveHints, saveText, workOn } from "./store.mjs";
import { solutionOf } from "./course.mjs";

const hintNames = ["a nudge", "an idea", "almost the code"];
const patience = 400; // [ms] from the last key to writing
const pause = 1000; // [ms] from the last key to building: by then a reader reads over what is there

class Box {
  constructor(place, unit) {
    this.unit = unit;
    this.parts = this.build(place);
    this.judging = new Judging(unit, this.parts, {
      text: () => this.write().then(() => this.now()),
      mark: (messages) => this.editor?.mark(messages),
      hint: () => this.hint(),
      judged: () => this.refresh(),
    });
    addEventListener("pagehide", () => this.write());
    document.addEventListener("visibilitychange", () => this.write());
    onWorkOfOthers((id) => (id === undefined || id === unit.id) && this.follow());
  }

  // ── What it is made of ──

  button(label, act, properties = {}) {
    return element("button", { type: "button", onclick: act, ...properties }, label);
  }

  build(place) {
    const help = element("p", { id: `keys-${this.unit.number}`, className: "keys" },
      "Ctrl-Enter checks. Tab indents; Escape, then Tab, leaves the editor. Where a case fails, the verdict shows what your code printed.");
    const parts = {
      code: element("div", { className: "editor" }), help, hints: element("ol", { className: "hints", "aria-live": "polite" }),
      check: this.button("Check", () => this.judging.press(), { className: "main" }),
      hint: this.button("Hint", () => this.hint()), reset: this.button("Reset", () => this.reset()),
      solution: this.button("Solution", () => this.solution(), { hidden: true }),
      progress: element("div", { className: "download", hidden: true }),
      note: element("p", { className: "note", role: "status" }),
      line: element("p", { className: "verdict-line", role: "status", "aria-live": "polite" }),
      text: element("pre", { className: "verdict", hidden: true }),
      next: element("p", { className: "next", hidden: true }),
      old: element("details", { className: "old-texts", hidden: true }),
      answer: element("div", { className: "solution", hidden: true }),
    };
    parts.code.append(element("pre", {}, this.unit.stub)); // until the editor is there
    parts.code.style.minHeight = `${this.unit.stub.split("\n").length * 1.5 + 1}em`;
    const buttons = element("div", { className: "buttons" }, parts.check, parts.hint, parts.reset, parts.solution);
    const frame = element("div", { className: "exercise" }, parts.code, help, buttons, parts.progress, parts.note,
      parts.line, parts.text, parts.next, parts.hints, parts.answer, parts.old);
    const command = foldCommand(place);
    place.append(contractText(this.unit), frame, command);
    return parts;
  }

  async open() {
    const work = await workOn(this.unit.id);
    this.base = work.text;
    this.draft = work.text ?? this.unit.stub;
    this.parts.code.firstChild.textContent = this.draft;
    for (let i = 0; i < work.hints; ++i) this.showHint(i);
    this.showState(work);
    if (work.last && work.checked === this.draft) this.judging.show(work.last);
    const near = new IntersectionObserver((seen) => {
      if (!seen.some(({ isIntersecting }) => isIntersecting)) return;
      near.disconnect();
      this.edit();
    }, { rootMargin: "800px" });
    near.observe(this.parts.code);
  }

  async edit() {
    this.editor = await makeEditor(this.parts.code, {
      text: this.draft, label: `C++ of exercise ${this.unit.number}, ${this.unit.name}`,
      describedBy: this.parts.help.id, check: () => this.judging.check(), changed: () => this.changed(), focused: () => this.buildAhead(),
    });
    this.parts.code.style.minHeight = "";
    this.judging.markAgain();
  }

  // ── The text, here and on disk ──

  now() {
    return this.editor?.text() ?? this.draft;
  }

  changed() {
    clearTimeout(this.timer);
    this.dirty = true;
    this.timer = setTimeout(() => this.write(), patience);
    clearTimeout(this.builder);
    this.builder = setTimeout(() => this.buildAhead(), pause);
  }

  buildAhead() {
    clearTimeout(this.builder);
    this.judging.buildAhead(this.now()).catch(() => {}); // the check says what is wrong
  }

  async write() {
    if (!this.dirty) return;
    clearTimeout(this.timer);
    this.dirty = false;
    const text = this.now(), base = this.base;
    this.base = text;
    this.showState(await saveText(this.unit.id, text, base));
  }

  /** Another tab may have written. */
  async follow() {
    if (this.dirty) return;
    const work = await workOn(this.unit.id);
    if (this.dirty) return;
    this.base = work.text;
    const text = work.text ?? this.unit.stub;
    if (text !== this.now()) this.put(text);
    this.showState(work);
  }

  put(text) {
    this.draft = text;
    if (this.editor) this.editor.replace(text);
    else this.parts.code.firstChild.textContent = text;
  }

  async replace(text) {
    await this.write();
    const work = await replaceText(this.unit.id, text);
    this.base = text;
    this.put(text);
    this.parts.note.textContent = "";
    this.parts.answer.hidden = true;
    this.showState(work);
  }

  async refresh() {
    this.showState(await workOn(this.unit.id));
  }

  showState(work) {
    this.parts.solution.hidden = !work.passed;
    this.parts.old.hidden = work.old.length === 0;
    const entries = work.old.map(({ text, at }) => element("li", {}, element("details", {},
      element("summary", {}, `${new Date(at).toLocaleString()}: ${this.nameOf(text, work)}, ${text.split("\n").length} lines`),
      element("pre", {}, text), this.button("Put this back", () => this.replace(text)))));
    this.parts.old.replaceChildren(element("summary", {}, "Earlier texts of yours"), element("ul", {}, ...entries));
  }

  /** What a reader may know a text by. */
  nameOf(text, work) {
    if (text === this.unit.stub) return "the untouched exercise";
    return text === work.right ? "it has passed" : "not passed";
  }

  // ── What the buttons do ──

  showHint(i) {
    for (const earlier of this.parts.hints.querySelectorAll("details")) earlier.open = false;
    this.parts.hints.append(element("li", {}, element("details", { open: true },
      element("summary", {}, `Hint ${i + 1} of ${this.unit.hints.length}: ${hintNames[i]}`), element("p", {}, ...inlineMarkdown(this.unit.hints[i])))));
    this.parts.hint.disabled = i + 1 >= this.unit.hints.length;
  }

  async hint() {
    const next = this.parts.hints.childElementCount;
    if (next >= this.unit.hints.length) return;
    this.showHint(next);
    this.parts.hints.lastChild.scrollIntoView({ block: "nearest" }); // it may be below a long verdict
    await saveHints(this.unit.id, next + 1);
  }

  async reset() {
    await this.replace(this.unit.stub);
    this.judging.clear();
    this.parts.note.textContent = "The untouched exercise is back. Your text is kept below, under “Earlier texts of yours”.";
    this.editor?.focus();
  }

  async solution() {
    const { answer } = this.parts;
    if (!answer.hidden) return void (answer.hidden = true);
    const text = await solutionOf(this.unit).catch((error) => `// ${error.message}`);
    answer.replaceChildren(element("p", {}, "How it can be done:"), element("pre", {}, text));
    answer.hidden = false;
  }
}

/** Makes an exercise of the place that says how to write it on the command line. */
export async function makeBox(place, unit) {
  await new Box(place, unit).open();
}
