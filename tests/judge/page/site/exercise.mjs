// What the exercises add to a page: an editor in each box "Now write", the picture of progress on the
// front page, and the service worker that keeps all of it for when there is no network.
import { base, units } from "./course.mjs";
import { element } from "./element.mjs";
import { makeBox } from "./box.mjs";
import { showProgress } from "./progress.mjs";

async function keepOffline() {
  if (!navigator.serviceWorker) return;
  await navigator.serviceWorker.register(new URL("../service_worker.js", base));
  const { active } = await navigator.serviceWorker.ready;
  // What this page has loaded before anybody kept it.
  const addresses = performance.getEntriesByType("resource").map(({ name }) => name);
  active.postMessage({ keep: [location.href.replace(/#.*/, ""), ...addresses] });
}

async function makeBoxes() {
  const known = await units();
  for (const place of document.querySelectorAll(".now-write[id]")) {
    const unit = known.find(({ number }) => place.id === `now-write-${number}`);
    if (unit) await makeBox(place, unit);
  }
}

document.head.append(element("link", { rel: "stylesheet", href: new URL("exercise.css", base).href }));
const started = Promise.all([makeBoxes(), showProgress()]);
started.then(() => {
  // The boxes have pushed the text below them: to where the link leads, again.
  if (location.hash) document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();
  document.documentElement.classList.add("exercises-ready");
}, (error) => console.error("The exercises of this page cannot be shown:", error));
addEventListener("load", () => keepOffline().catch(() => {})); // a private window keeps nothing
if (document.readyState === "complete") keepOffline().catch(() => {});
