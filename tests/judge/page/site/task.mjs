// The text of a box beside its editor: what the contract demands, and how to do it on the command line.
import { base } from "./course.mjs";
import { element } from "./element.mjs";

const contracts = {};

function pageOf(chapter) {
  contracts[chapter] ??= fetch(new URL(`../exercises-${chapter}.html`, base))
    .then((response) => (response.ok ? response.text() : ""))
    .then((text) => new DOMParser().parseFromString(text, "text/html"));
  return contracts[chapter];
}

/** What stands below the heading of an exercise on the contract's page, before its signature, without the title: the box has it. */
async function demanded(unit) {
  const anchor = (await pageOf(unit.chapter)).getElementById(`exercises-${unit.chapter}-${unit.number}`);
  const parts = [];
  let next = anchor?.nextElementSibling?.nextElementSibling; // below the heading
  for (; next && !next.matches(".fragment"); next = next.nextElementSibling) parts.push(document.importNode(next, true));
  parts[0]?.querySelector(":scope > b:first-child")?.remove();
  return parts.filter((part) => part.textContent.trim() !== "");
}

/** What the contract's page says before its first exercise: types, conventions, what one may use. Not its link to this page. */
async function given(unit) {
  const parts = [];
  let next = (await pageOf(unit.chapter)).querySelector(".page-contents")?.nextElementSibling?.nextElementSibling;
  for (; next && !next.matches("a[id]"); next = next.nextElementSibling)
    parts.push(next.matches("h2") ? element("p", {}, element("strong", {}, next.textContent.trim())) : document.importNode(next, true));
  return parts;
}

/** The contract's words: they arrive a moment later. What holds for all is open in a page's first box. */
export function contractText(unit) {
  const place = element("div", { className: "demanded" });
  const first = document.querySelector(".now-write[id]")?.id === `now-write-${unit.number}`;
  const common = element("details", { open: first },
    element("summary", {}, "For all exercises of this chapter: types, and what you may use"));
  const fill = async () => {
    common.append(...(await given(unit)));
    place.append(common, ...(await demanded(unit)));
  };
  fill().catch(() => {}); // without it, the link to the contract is left
  return place;
}

/** Folds away what the box says about the command line, and takes it out of the box. */
export function foldCommand(place) {
  const command = [...place.querySelectorAll(":scope > .fragment")].at(-1);
  const contract = command.previousElementSibling;
  for (const node of contract.childNodes)
    if (node.nodeType === Node.TEXT_NODE) node.data = node.data.replace(/\s*Ask the judge:/, "");
  place.querySelector(":scope > details")?.remove();
  const words = element("p", {}, "On your own computer, in the course's folder:");
  return element("details", { className: "on-the-command-line" },
    element("summary", {}, "On the command line"), words, command);
}
