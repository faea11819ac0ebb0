// What a first check downloads: it is said before, once, and what the judge has not asked for itself
// is fetched afterwards, so that every exercise can be judged offline.
import { base, manifest, pages, units } from "./course.mjs";
import { element, megabytes } from "./element.mjs";
import { saveSetting, setting } from "./store.mjs";

/** Whether the reader has agreed to download this version. */
export async function hasAgreed() {
  return (await setting("agreed")) === (await manifest()).version;
}

async function question() {
  const size = megabytes((await manifest()).total_wire);
  return element("p", {}, `The first check downloads a C++ compiler and the judge: ${size}, once. They stay in ` +
    "this browser, for all exercises and without a network. What you write is sent nowhere.");
}

/** Asks in `place`; the promise is of the answer. */
export async function askToDownload(place) {
  const text = await question();
  const before = document.activeElement;
  const answer = await new Promise((resolve) => {
    const yes = element("button", { type: "button", className: "main", onclick: () => resolve(true) }, "Download and check");
    const no = element("button", { type: "button", onclick: () => resolve(false) }, "Not now");
    place.replaceChildren(text, element("div", { className: "buttons" }, yes, no));
    place.hidden = false;
    yes.focus();
  });
  place.replaceChildren();
  place.hidden = true;
  before.focus({ preventScroll: true }); // who uses the keyboard goes on where they were
  if (answer) await saveSetting("agreed", (await manifest()).version);
  return answer;
}

/** A bar in `place` that shows {done, total} [bytes], and what comes after them. */
export function progressBar(place) {
  const bar = element("progress", { max: 1, "aria-label": "Download" });
  const words = element("span", {});
  return {
    show({ done, total }) {
      if (!bar.isConnected) place.replaceChildren(bar, words);
      place.hidden = false;
      const whole = done >= total;
      if (whole) bar.removeAttribute("value");
      else bar.value = done / total;
      words.textContent = whole ? "Starting the compiler and the judge" : `${megabytes(done)} of ${megabytes(total)}`;
    },
    remove() {
      place.replaceChildren();
      place.hidden = true;
    },
  };
}

/** What is small and belongs to other exercises: the service worker sees it pass, and keeps it. */
async function passSmallFiles({ version, files }) {
  if (!navigator.serviceWorker?.controller || (await setting("small files")) === version) return;
  const judges = files.filter(({ path }) => path.startsWith("judge/")).map(({ path }) => path.replace(".wasm", ".mjs"));
  const solutions = (await units()).map(({ id }) => `solutions/${id}.cpp`);
  const chapters = new Set(Object.values(await pages()).map((page) => `../${page}`));
  for (const path of [...judges, ...solutions, ...chapters]) {
    const response = await fetch(new URL(path, base));
    if (!response.ok) throw new Error(`${path}: ${response.status} ${response.statusText}`);
    await response.arrayBuffer(); // whole
  }
  await saveSetting("small files", version);
}

let completing = false;

/** Fetches what is not kept yet, so that every exercise can be judged without a network. */
export async function completeDownload() {
  if (completing) return;
  completing = true;
  const { Assets } = await import("./assets.mjs");
  const about = await manifest();
  const assets = new Assets(about);
  for (const { path } of about.files) await assets.keep(path).catch(() => {}); // after the next check again
  await passSmallFiles(about).catch(() => {});
  completing = false;
}
