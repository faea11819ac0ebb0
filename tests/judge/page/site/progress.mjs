// The picture of progress on the front page, as ./tumble list draws it; and the work as a file.
import { addressOf, units, unitsByChapter } from "./course.mjs";
import { element } from "./element.mjs";
import { allWork, onWorkOfOthers } from "./store.mjs";
import { resetSince, takeOver, workAsZip, workIn, written } from "./work.mjs";

const isDone = (work) => work?.last?.passed && work.checked === work.text;

/** In words, as ./tumble list says it. */
function stateOf(work) {
  if (!work) return "not begun";
  const state = isDone(work) ? "passed" : !work.last ? "not checked yet"
    : work.checked === work.text ? work.last.summary : "changed since the last check";
  if (work.passed && !isDone(work)) return "has passed; changed since";
  return work.tries ? `${state}, ${work.tries} ${work.tries === 1 ? "try" : "tries"}` : state;
}

const markOf = (work) => (work?.passed ? (isDone(work) ? "✓" : "✎") : work?.tries ? "✗" : "·");

async function markLink(unit, work) {
  const words = `${unit.number} ${unit.name}: ${stateOf(work)}`;
  const style = work?.passed ? (isDone(work) ? "holds" : "") : work?.tries ? "fails" : "";
  return element("a", { href: (await addressOf(unit)) ?? "#", title: words, "aria-label": words, className: style },
    element("span", { className: "number" }, unit.number), markOf(work));
}

async function chapterLine(name, all, work) {
  const marks = await Promise.all(all.map((unit) => markLink(unit, work.get(unit.id))));
  const title = `${+name.slice(0, 2)} ${name[3].toUpperCase()}${name.slice(4).replaceAll("_", " ")}`;
  return element("li", {}, element("span", { className: "chapter" }, title),
    element("span", { className: "marks" }, ...marks));
}

async function draw(list, count) {
  const work = new Map((await allWork()).map((each) => [each.id, each]));
  const chapters = [...(await unitsByChapter())], all = chapters.flatMap(([, of]) => of);
  list.replaceChildren(...(await Promise.all(chapters.map(([name, of]) => chapterLine(name, of, work)))));
  const done = all.filter(({ id }) => work.get(id)?.passed).length;
  const changed = all.filter(({ id }) => work.get(id)?.passed && !isDone(work.get(id))).length;
  count.textContent = `${done} of ${all.length} exercises have passed${changed ? `, ${changed} of them changed since (✎)` : ""}`;
}

// ── The work as a file ──

async function download(say) {
  const work = await written(), count = work.length;
  if (count === 0) return say(`Nothing to download.${await warning(work)}`);
  const address = URL.createObjectURL(await workAsZip());
  element("a", { href: address, download: "tumble-exercises.zip" }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
  say(`${count} ${count === 1 ? "exercise" : "exercises"} in tumble-exercises.zip. You can hand it in, or open it in another browser.${await warning(work)}`);
}

const numbersOf = async (work) => {
  const ids = new Set(work.map(({ id }) => id));
  return (await units()).filter(({ id }) => ids.has(id)).map(({ number }) => number);
};

/** Of what is in the file but has not passed as it is, and of what is not in it but has passed. */
async function warning(work) {
  const open = await numbersOf(work.filter((each) => !isDone(each)));
  const reset = await numbersOf(await resetSince());
  const ofOpen = open.length === 0 ? "" : ` Not passed as ${open.length === 1 ? "it is" : "they are"} now: ${open.join(", ")}.`;
  const ofReset = reset.length === 0 ? "" : ` Not in it: ${reset.join(", ")}, reset after passing. The text that passed is in the box, under “Earlier texts of yours”.`;
  return ofOpen + ofReset;
}

async function open(file, say) {
  try {
    const files = await workIn(await file.arrayBuffer());
    const replaced = files.filter(({ replaces }) => replaces).map(({ id }) => id);
    const question = `Replace your text of ${replaced.join(", ")}? What you have now is kept in its box, under “Earlier texts of yours”.`;
    if (replaced.length > 0 && !confirm(question)) return say("Nothing is changed.");
    await takeOver(files);
    say(`${files.length === 1 ? "1 exercise is" : `${files.length} exercises are`} open. The file holds no verdicts: check ${files.length === 1 ? "it" : "each"} in its page.`);
  } catch (error) {
    say(`${file.name} cannot be opened: ${error.message}.`);
  }
}

function controls(redraw) {
  const words = element("p", { role: "status", "aria-live": "polite" });
  const say = (text) => (words.textContent = text);
  const input = element("input", { type: "file", accept: ".zip,application/zip", hidden: true });
  input.onchange = async () => {
    if (input.files[0]) await open(input.files[0], say);
    input.value = "";
    redraw();
  };
  const save = element("button", { type: "button", onclick: () => download(say) }, "Download my work");
  const load = element("button", { type: "button", onclick: () => input.click() }, "Open my work …");
  return [element("div", { className: "buttons" }, save, load, input), words];
}

/** Draws it above the list of chapters, on the page that has one. */
export async function showProgress() {
  const heading = document.getElementById("readme-the-chapters");
  if (!heading) return;
  const list = element("ul", {}), count = element("p", { className: "count" });
  const redraw = () => draw(list, count);
  const words = element("p", {}, "You can write every exercise in its page: a compiler and the judge run in your browser. " +
    "Your work stays in this browser. A verdict in a page is for learning: if your course gives grades, hand in the file " +
    "that “Download my work” gives you.");
  await redraw();
  heading.before(element("section", { className: "exercise-progress", "aria-labelledby": "your-exercises" },
    element("h2", { id: "your-exercises" }, "Your exercises"), words, list, count, ...controls(redraw)));
  sayAtTheStart();
  onWorkOfOthers(redraw);
}

/** Where a newcomer begins to read. */
function sayAtTheStart() {
  const start = [...document.querySelectorAll("#text :is(b, strong)")].find(({ textContent }) => textContent.startsWith("Start reading"));
  start?.after(" ", element("a", { href: "#your-exercises" }, "You can write the exercises in these pages."));
}
