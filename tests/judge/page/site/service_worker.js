// Keeps pages that were visited and what the exercises have downloaded, for when there is no network.
// What is small is asked for anew wherever the network answers. The compiler and the judge are kept by
// the version in exercises/manifest.json: a new one replaces them.
const root = new URL("./", self.location).href;
const exercises = new URL("exercises/", root).href;
const manifest = new URL("manifest.json", exercises).href;
const pages = "tumble-pages";
const prefix = "tumble-exercises-";

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));

const isWhole = (response) => response.ok && response.status === 200 && response.type === "basic";

async function keep(name, address, response) {
  if (isWhole(response)) await (await caches.open(name)).put(address, response);
}

// ── The version ──

let known = null; // a promise of {version, paths}

async function read(response) {
  const { version, files } = await response.json();
  return { version, paths: new Set(files.map(({ path }) => new URL(path, exercises).href)) };
}

async function rememberVersion(response) {
  const now = await read(response);
  known = Promise.resolve(now);
  for (const name of await caches.keys())
    if (name.startsWith(prefix) && name !== prefix + now.version) await caches.delete(name);
}

async function version() {
  known ??= caches.match(manifest).then((kept) => (kept ? read(kept) : null));
  const now = await known;
  if (!now) known = null;
  return now;
}

// ── Answers ──

/** The page behind "/" is index.html, and the other way round. */
function otherName(address) {
  return address.endsWith("/index.html") ? address.slice(0, -"index.html".length)
    : address.endsWith("/") ? address + "index.html" : address;
}

async function fromNetwork(event, address) {
  try {
    const response = await fetch(event.request);
    event.waitUntil(keep(pages, address, response.clone()));
    if (address === manifest && response.ok) event.waitUntil(rememberVersion(response.clone()));
    return response;
  } catch (error) {
    const kept = (await caches.match(address)) ?? (await caches.match(otherName(address)));
    if (kept) return kept;
    throw error;
  }
}

async function kept(event, address, name) {
  const found = await (await caches.open(name)).match(address);
  if (found) return found;
  const response = await fetch(event.request, { cache: "no-cache" });
  event.waitUntil(keep(name, address, response.clone()));
  return response;
}

async function answer(event, address) {
  const now = address.startsWith(exercises) ? await version() : null;
  return now?.paths.has(address) ? kept(event, address, prefix + now.version) : fromNetwork(event, address);
}

self.addEventListener("fetch", (event) => {
  const address = event.request.url.replace(/[?#].*/, "");
  if (event.request.method === "GET" && address.startsWith(root)) event.respondWith(answer(event, address));
});

/** What a page has loaded before it was under this worker. */
async function keepLoaded(addresses) {
  const now = await version();
  for (const each of addresses) {
    const address = each.replace(/[?#].*/, "");
    if (!address.startsWith(root) || now?.paths.has(address) || (await caches.match(address))) continue;
    const response = await fetch(address).catch(() => null);
    if (response) await keep(pages, address, response.clone());
    if (response?.ok && address === manifest) await rememberVersion(response);
  }
}

self.addEventListener("message", (event) => {
  if (event.data.keep) event.waitUntil(keepLoaded(event.data.keep));
});
