// How many exercises of each chapter have passed, beside its name in the list of all pages.
import { unitsByChapter } from "./course.mjs";
import { allWork, onWorkOfOthers } from "./store.mjs";

async function draw() {
  const passed = new Set((await allWork()).filter((work) => work.passed).map(({ id }) => id));
  for (const [chapter, all] of await unitsByChapter()) {
    const link = document.querySelector(`#sidebar a[href="exercises-${chapter}.html"]`);
    const done = all.filter(({ id }) => passed.has(id)).length;
    if (!link || done === 0) continue;
    link.textContent = `${done} of ${all.length}`;
    link.setAttribute("aria-label", `exercises: ${done} of ${all.length} have passed`);
  }
}

export function showInSidebar() {
  draw();
  document.addEventListener("exercise-judged", draw);
  onWorkOfOthers(draw);
}
