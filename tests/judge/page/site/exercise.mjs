// What the exercises add to a page: an editor in each box "Now write", the picture of progress on the
// front page, and the service worker that keeps all of it for when there is no network.
import { base, manifest, units } from "./course.mjs";
import { element } from "./element.mjs";
import { makeBox } from "./box.mjs";
import { offerMine } from "./mine.mjs";
import { showProgress } from "./progress.mjs";
import { showInSidebar } from "./sidebar.mjs";

/** From then on the service worker sees what the page asks for; not after a reload that goes around it. */
function seenByWorker() {
  if (navigator.serviceWorker.controller) return null;
  return new Promise((resolve) => navigator.serviceWorker.addEventListener("controllerchange", resolve, { once: true }));
}

async function keepOffline() {
  if (!navigator.serviceWorker) return;
  const seen = seenByWorker();
  await navigator.serviceWorker.register(new URL("../service_worker.js", base));
  await seen;
  const keep = (addresses) => navigator.serviceWorker.controller.postMessage({ keep: addresses });
  keep([location.href.replace(/#.*/, "")]);
  // What this page has asked for before anybody kept it, also what arrives only now.
  new PerformanceObserver((list) => keep(list.getEntries().map(({ name }) => name))).observe({ type: "resource", buffered: true });
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
manifest().then(({ engine }) => engine && offerMine(), () => {}); // not where some chapters are left out
showInSidebar();
keepOffline().catch(() => {}); // a private window keeps nothing
