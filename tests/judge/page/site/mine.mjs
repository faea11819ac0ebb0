// Figures that ask the reader's own functions: those that pass, and solutions for the others.
import { units } from "./course.mjs";
import { askToDownload, hasAgreed } from "./download.mjs";
import { element } from "./element.mjs";
import { theJudge } from "./judging.mjs";
import { allWork } from "./store.mjs";

/** The reader's texts that have passed last, [{id, text}]. */
async function passing() {
  return (await allWork()).filter(({ right }) => right).map(({ id, right }) => ({ id, text: right }));
}

/** What a reader is told of an answer. */
async function wordsFor({ numbers, own, outcome, detail }) {
  if (!numbers) return `Your functions give no answer: ${outcome}, ${detail}.`;
  const yours = (await units()).filter(({ id }) => own.includes(id)).map(({ number }) => number);
  if (yours.length === 0) return "This figure needs functions of yours that have not passed yet. You see the solutions.";
  return `Yours: ${yours.join(", ")}. Where it needs others, it takes the solutions.`;
}

class Mine {
  constructor(figure) {
    this.figure = figure;
    this.box = element("input", { type: "checkbox", onchange: () => this.turn() });
    this.words = element("p", { role: "status" });
    this.place = element("section", { hidden: true });
    const label = element("label", {}, this.box, " Ask my own functions");
    figure.panel.append(element("section", { className: "mine" }, label, this.place, this.words));
    figure.onchange = () => this.follow();
  }

  turn() {
    clearTimeout(this.timer); // nobody wants that answer any more
    this.asked = null;
    this.words.textContent = "";
    this.show([]);
    if (this.box.checked) this.ask();
  }

  show(numbers) {
    this.figure.module.take(numbers);
    this.figure.draw();
  }

  /** Settings may have changed: then the answer is no longer one to them. */
  follow() {
    if (!this.box.checked || `${this.figure.module.question()}` === this.asked) return;
    this.asked = `${this.figure.module.question()}`;
    this.figure.module.take([]);
    this.words.textContent = "Asking your functions …";
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.ask(), 200); // not for what a pointer passes on its way
  }

  async ask() {
    try {
      if (!(await hasAgreed()) && !(await askToDownload(this.place))) return void (this.box.checked = false);
      this.words.textContent = "Asking your functions …";
      await this.askNow(this.figure.module.question());
    } catch (error) {
      this.words.textContent = `Your functions cannot be asked here: ${error.message}.`;
    }
  }

  async askNow(numbers) {
    this.asked = `${numbers}`;
    const { chapter, declared, module } = this.figure;
    const digits = chapter.slice(0, 2);
    const answer = await (await theJudge()).answerFigure(digits, declared.topic, numbers, await passing());
    if (!this.box.checked || `${module.question()}` !== `${numbers}`) return; // the answer to an earlier question
    this.show(answer.numbers ?? []);
    this.words.textContent = await wordsFor(answer);
  }
}

/** Adds the choice to every figure of the page that can ask. */
export function offerMine() {
  if (typeof tumbleMoving !== "undefined") tumbleMoving.each((figure) => figure?.declared.topic && new Mine(figure));
}
