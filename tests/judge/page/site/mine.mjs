// Figures that move by the reader's own functions: those that pass, and solutions for the others.
import { units } from "./course.mjs";
import { askToDownload, hasAgreed } from "./download.mjs";
import { element } from "./element.mjs";
import { theJudge } from "./judging.mjs";
import { allWork } from "./store.mjs";

/** The reader's files that pass as they are, [{id, text}], in the course's order. */
async function passing() {
  const work = new Map((await allWork()).map((each) => [each.id, each]));
  const done = (await units()).map(({ id }) => work.get(id)).filter((each) => each?.last?.passed && each.checked === each.text);
  return done.map(({ id, text }) => ({ id, text }));
}

class Mine {
  constructor(figure) {
    this.figure = figure;
    this.box = element("input", { type: "checkbox", onchange: () => this.turn() });
    this.words = element("p", { className: "mine", role: "status" });
    this.place = element("div", {});
    figure.rows.append(element("div", {}, element("label", {}, this.box, " by your own functions")), this.place, this.words);
    figure.asked = () => this.askSoon();
  }

  turn() {
    if (this.box.checked) return this.ask();
    this.show([]);
    this.words.textContent = "";
  }

  show(states) {
    this.figure.module.take(states);
    this.figure.draw();
  }

  /** Not for what a pointer passes on its way; and not if the question is the same. */
  askSoon() {
    if (!this.box.checked || `${this.figure.module.question()}` === this.last) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.ask(), 300);
  }

  async ask() {
    try {
      if (!(await hasAgreed()) && !(await askToDownload(this.place))) return void (this.box.checked = false);
      const question = this.figure.module.question();
      this.last = `${question}`;
      this.words.textContent = "Computing …";
      this.answer(await (await theJudge()).motion(question, await passing()));
    } catch (error) {
      this.words.textContent = `Your functions cannot be asked here: ${error.message}.`;
    }
  }

  async answer({ states, own, outcome, detail }) {
    if (!this.box.checked) return;
    this.show(states ?? []);
    if (!states) return void (this.words.textContent = `Your functions: ${outcome}. ${detail}`);
    const numbers = (await units()).filter(({ id }) => own.includes(id)).map(({ number }) => number);
    this.words.textContent = numbers.length > 0 ? `Yours: ${numbers.join(", ")}. The others are solutions.`
      : "No exercise of yours passes yet: these are the solutions.";
  }
}

/** Adds the choice to every figure of the page that can show another's motion. */
export function offerMine() {
  if (typeof tumbleMoving !== "undefined") tumbleMoving.each((figure) => figure.declared.given && new Mine(figure));
}
