// In the list of all pages: how many exercises of each chapter have passed, and the way to the next one.
import { addressOf, unitsByChapter } from "./course.mjs";
import { allWork, onWorkOfOthers } from "./store.mjs";

const links = {}; // of each chapter's exercises; they lead to its contract until somebody can write

async function draw() {
  const passed = new Set((await allWork()).filter((work) => work.passed).map(({ id }) => id));
  for (const [chapter, all] of await unitsByChapter()) {
    const link = (links[chapter] ??= document.querySelector(`#sidebar a[href="exercises-${chapter}.html"]`));
    if (!link) continue;
    const next = await addressOf(all.find(({ id }) => !passed.has(id)) ?? all[0]);
    if (next) link.href = next;
    const done = all.filter(({ id }) => passed.has(id)).length;
    if (done === 0) continue;
    link.textContent = `${done} of ${all.length}`;
    link.setAttribute("aria-label", `exercises: ${done} of ${all.length} have passed`);
  }
}

export function showInSidebar() {
  draw();
  document.addEventListener("exercise-judged", draw);
  onWorkOfOthers(draw);
}
