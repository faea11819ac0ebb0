// Keeps pages that were visited, with all that belongs to them, for when there is no network. What the
// network has is asked for anew wherever it answers. The large files of the exercises are kept by
// exercises/assets.mjs, unpacked.
const root = new URL("./", self.location).href;
const pages = "tumble-pages";

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));

const isWhole = (response) => response.ok && response.status === 200 && response.type === "basic";

async function keep(name, address, response) {
  if (isWhole(response)) await (await caches.open(name)).put(address, response);
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
    return response;
  } catch (error) {
    const kept = (await caches.match(address)) ?? (await caches.match(otherName(address)));
    if (kept) return kept;
    throw error;
  }
}

self.addEventListener("fetch", (event) => {
  const address = event.request.url.replace(/[?#].*/, "");
  if (event.request.method !== "GET" || !address.startsWith(root) || address.endsWith(".zst")) return;
  event.respondWith(fromNetwork(event, address));
});

/** What a page has loaded before it was under this worker. */
async function keepLoaded(addresses) {
  for (const each of addresses) {
    const address = each.replace(/[?#].*/, "");
    if (!address.startsWith(root) || address.endsWith(".zst") || (await caches.match(address))) continue;
    const response = await fetch(address).catch(() => null);
    if (response) await keep(pages, address, response);
  }
}

self.addEventListener("message", (event) => {
  if (event.data.keep) event.waitUntil(keepLoaded(event.data.keep));
});
