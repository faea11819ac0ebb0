// Large files of the page: fetched packed, once, and kept unpacked for the next time, offline too.
import { joined } from "./bytes.mjs";
import { decompress } from "./fzstd.mjs";

const base = new URL("./", import.meta.url);

/** What the page can download, with sizes: manifest.json. */
export async function manifest() {
  const response = await fetch(new URL("manifest.json", base));
  if (!response.ok) throw new Error(`manifest.json: ${response.status} ${response.statusText}`);
  return response.json();
}

/** The bytes of a response, with a word to `hear` about each piece. */
async function received(response, hear) {
  const pieces = [];
  for (const reader = response.body.getReader(); ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    pieces.push(value);
    hear(value.length);
  }
  return joined(pieces);
}

/** Where files are kept, by the version of the whole; what is there of other versions goes. */
async function store(version) {
  if (!globalThis.caches) return null; // not a secure address: nothing is kept
  const name = `tumble-exercises-${version}`;
  for (const other of await caches.keys())
    if (other.startsWith("tumble-exercises-") && other !== name) await caches.delete(other);
  return caches.open(name);
}

const type = (path) => (path.endsWith(".wasm") ? "application/wasm" : "application/octet-stream");

export class Assets {
  /**
   * @param about  the manifest
   * @param hear   is called with {done, total} [bytes over the wire] while something is downloaded
   */
  constructor(about, hear = () => {}) {
    this.about = about;
    this.hear = hear;
    this.done = 0;
    this.total = 0;
    this.expected = new Set(); // paths that `total` counts already
    this.kept = store(about.version);
  }

  address(path) {
    return new URL(path, base).href;
  }

  /** A file as a response, unpacked. */
  async response(path) {
    const kept = await this.kept;
    const known = await kept?.match(this.address(path));
    if (known) return known;
    const response = new Response(await this.download(path), { headers: { "content-type": type(path) } });
    await kept?.put(this.address(path), response.clone()).catch(() => {}); // no room: next time again
    return response;
  }

  async isKept(path) {
    return Boolean(await (await this.kept)?.match(this.address(path)));
  }

  /** Sees to it that a file is there the next time. */
  async keep(path) {
    if (!(await this.isKept(path))) await this.response(path);
  }

  /** All files of a folder will be asked for: the total is known before the first of them comes. */
  async expect(folder) {
    for (const { path, wire } of this.about.files) {
      if (!path.startsWith(`${folder}/`) || (await this.isKept(path))) continue;
      this.expected.add(path);
      this.total += wire;
    }
  }

  async bytes(path) {
    return new Uint8Array(await (await this.response(path)).arrayBuffer());
  }

  async download(path) {
    const known = this.about.files.find((each) => each.path === path);
    if (!known) throw new Error(`${path} is not in manifest.json`);
    if (!this.expected.delete(path)) this.total += known.wire;
    const response = await fetch(`${this.address(path)}.zst`);
    if (!response.ok) throw new Error(`${path}.zst: ${response.status} ${response.statusText}`);
    const packed = await received(response, (bytes) => this.hear({ done: (this.done += bytes), total: this.total }));
    const bytes = decompress(packed, new Uint8Array(known.bytes));
    if (bytes.length !== known.bytes) throw new Error(`${path}.zst is not whole: ${bytes.length} of ${known.bytes} bytes`);
    return bytes;
  }
}
