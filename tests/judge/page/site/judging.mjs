// From the button Check to the verdict.
import { addressOf, base, unitAfter } from "./course.mjs";
import { askToDownload, completeDownload, hasAgreed, progressBar } from "./download.mjs";
import { element } from "./element.mjs";
import { saveVerdict } from "./store.mjs";
import { compilerMessages, showVerdict } from "./verdict.mjs";

let judge = null;

/** One compiler and one judge for all boxes of a page. */
export async function theJudge() {
  judge ??= import("./client.mjs").then(({ Judge }) => new Judge(base.href));
  return judge;
}

const freshSeed = () => 1 + Math.floor(Math.random() * 1e6);

export class Judging {
  /**
   * @param parts of the box: check, progress, line, text, next
   * @param box {text(): what is there, kept; mark(messages), hint(), judged()}
   */
  constructor(unit, parts, box) {
    Object.assign(this, { unit, parts, box, busy: false });
  }

  async check(seed = freshSeed()) {
    if (this.busy) return;
    this.setBusy(true);
    try {
      if ((await hasAgreed()) || (await askToDownload(this.parts.progress))) await this.run(seed);
      else this.parts.text.classList.remove("of-before");
    } catch (error) {
      if (error.name === "AbortError") this.say("Stopped: there is no verdict.");
      else this.say(`The judge does not work here: ${error.message}. This is not a verdict on your code.`);
    }
    this.setBusy(false);
  }

  /** Has the compiler at work before the reader asks, where it is there already. */
  async buildAhead(text) {
    if (!this.busy && (await hasAgreed())) await (await theJudge()).buildAhead(this.unit.id, text);
  }

  /** The button: checks, or ends what runs too long for a reader. */
  press() {
    if (this.running) this.running.abort();
    else this.check();
  }

  async run(seed) {
    const { unit, parts, box } = this;
    const text = await box.text();
    const bar = progressBar(parts.progress);
    this.say("Starting the compiler …");
    parts.next.hidden = true;
    this.reveal();
    this.setRunning(new AbortController());
    try {
      const listeners = { onProgress: (at) => bar.show(at), onCompiling: () => this.say("Checking …"), onHung: (count) => this.sayHung(count), signal: this.running.signal };
      const verdict = await (await theJudge()).check(unit.id, text, { seed, ...listeners });
      await saveVerdict(unit.id, text, verdict); // what is shown is kept
      document.dispatchEvent(new Event("exercise-judged"));
      this.show(verdict);
      this.reveal();
      box.judged();
    } finally {
      this.setRunning(null);
      bar.remove();
    }
    completeDownload();
  }

  /** @param controller what ends the check that runs now, or null */
  setRunning(controller) {
    this.running = controller;
    this.parts.check.textContent = controller ? "Stop" : "Check";
    this.parts.check.setAttribute("aria-disabled", this.busy && !controller);
  }

  setBusy(busy) {
    this.busy = busy;
    this.parts.check.setAttribute("aria-disabled", busy);
    if (busy) this.parts.text.classList.add("of-before"); // until there is another verdict
  }

  sayHung(count) {
    this.say(`Checking … ${count === 1 ? "One call has" : `${count} calls have`} not come back in 2 s. Is there a loop without an end?`);
  }

  /** Ctrl-Enter is pressed in the editor, and the verdict may be below the window. */
  reveal() {
    this.parts.line.scrollIntoView({ block: "nearest" });
  }

  say(words) {
    this.parts.line.className = "verdict-line";
    this.parts.line.textContent = words;
  }

  show(verdict) {
    this.verdict = verdict;
    showVerdict(verdict, this.parts, { check: (seed) => this.check(seed), hint: () => this.box.hint() });
    this.parts.text.classList.remove("of-before");
    this.offerNext(verdict);
    this.markAgain();
  }

  /** Where to go on once this has passed, and where the file is that one hands in. */
  async offerNext(verdict) {
    const { next } = this.parts;
    next.hidden = true;
    if (!verdict.passed) return;
    const following = await unitAfter(this.unit), address = following && (await addressOf(following));
    if (this.verdict !== verdict) return;
    const link = address ? ["Next: ", element("a", { href: address }, `${following.number} ${following.name}`), ". "] : [];
    next.replaceChildren(...link, "To hand in, or to keep, what you have written: ",
      element("a", { href: new URL("../index.html#your-exercises", base).href }, "Download my work"), ".");
    next.hidden = false;
  }

  /** For an editor that came after the verdict. */
  markAgain() {
    if (this.verdict) this.box.mark(compilerMessages(this.verdict));
  }

  clear() {
    this.verdict = null;
    this.parts.text.hidden = this.parts.next.hidden = true;
    this.say("");
  }
}
