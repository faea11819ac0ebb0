// Zip files: written without compression, read as other programs write them.
const encoder = new TextEncoder();
const mostBytes = 4 << 20; // of one file, unpacked: an exercise has some hundred lines

const checksums = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

function checksum(bytes) {
  let sum = ~0;
  for (const byte of bytes) sum = checksums[(sum ^ byte) & 255] ^ (sum >>> 8);
  return ~sum >>> 0;
}

/** Bytes of little-endian numbers: [2, 5] is 5 in two bytes. */
function packed(fields) {
  const bytes = [];
  for (const [size, value] of fields)
    for (let i = 0; i < size; ++i) bytes.push(Math.floor(value / 256 ** i) % 256);
  return Uint8Array.from(bytes);
}

/** Date and time as MS-DOS writes them. */
function moment(date) {
  const time = (date.getHours() << 11) | (date.getMinutes() << 5) | (date.getSeconds() >> 1);
  return [time, ((date.getFullYear() - 1980) << 9) | ((date.getMonth() + 1) << 5) | date.getDate()];
}

/** What the local header and the directory both say about a file. */
function description(file, date) {
  const [time, day] = moment(date);
  const utf8 = 1 << 11;
  return [[2, 20], [2, utf8], [2, 0], [2, time], [2, day], [4, checksum(file.bytes)],
    [4, file.bytes.length], [4, file.bytes.length], [2, file.name.length], [2, 0]];
}

/** The zip of these files: [{path, text}] → Blob. */
export function writeZip(texts, date = new Date()) {
  const parts = [], directory = [];
  let at = 0;
  for (const { path, text } of texts) {
    const file = { name: encoder.encode(path), bytes: encoder.encode(text) };
    const said = description(file, date);
    directory.push(packed([[4, 0x02014b50], [2, 20], ...said, [2, 0], [2, 0], [2, 0], [4, 0], [4, at]]), file.name);
    const header = packed([[4, 0x04034b50], ...said]);
    parts.push(header, file.name, file.bytes);
    at += header.length + file.name.length + file.bytes.length;
  }
  const size = directory.reduce((sum, part) => sum + part.length, 0);
  const end = [[4, 0x06054b50], [2, 0], [2, 0], [2, texts.length], [2, texts.length], [4, size], [4, at], [2, 0]];
  return new Blob([...parts, ...directory, packed(end)], { type: "application/zip" });
}

/** Where the directory is: its record stands at the end, before a comment. */
function endRecord(view) {
  for (let at = view.byteLength - 22; at >= 0 && at > view.byteLength - 66000; --at)
    if (view.getUint32(at, true) === 0x06054b50)
      return { count: view.getUint16(at + 10, true), at: view.getUint32(at + 16, true) };
  throw new Error("it is not a zip file");
}

async function inflated(bytes, size) {
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const result = new Uint8Array(size);
  let at = 0;
  for (const reader = unpacked.getReader(); ; ) {
    const { done, value } = await reader.read();
    if (done) return result.subarray(0, at);
    if (at + value.length > size) throw new Error("a file in it is longer than it says");
    result.set(value, at);
    at += value.length;
  }
}

async function contents(view, entry) {
  if (entry.flags & 1) throw new Error(`${entry.path} in it is encrypted`);
  if (entry.size > mostBytes) throw new Error(`${entry.path} in it is too long for an exercise`);
  const start = entry.at + 30 + view.getUint16(entry.at + 26, true) + view.getUint16(entry.at + 28, true);
  const bytes = new Uint8Array(view.buffer, start, entry.packedSize);
  if (entry.method !== 0 && entry.method !== 8)
    throw new Error(`${entry.path} in it is compressed in a way that cannot be read here`);
  const plain = entry.method === 8 ? await inflated(bytes, entry.size) : bytes;
  if (checksum(plain) !== entry.checksum) throw new Error(`${entry.path} in it is damaged`);
  return new TextDecoder().decode(plain);
}

function entryAt(view, at) {
  if (view.getUint32(at, true) !== 0x02014b50) throw new Error("its list of files is damaged");
  const length = view.getUint16(at + 28, true);
  const rest = view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
  return {
    flags: view.getUint16(at + 8, true), method: view.getUint16(at + 10, true),
    checksum: view.getUint32(at + 16, true), packedSize: view.getUint32(at + 20, true),
    size: view.getUint32(at + 24, true), at: view.getUint32(at + 42, true),
    path: new TextDecoder().decode(new Uint8Array(view.buffer, at + 46, length)),
    next: at + 46 + length + rest,
  };
}

/** The files of a zip whose path `wanted` takes: ArrayBuffer → [{path, text}]. */
export async function readZip(buffer, wanted) {
  const view = new DataView(buffer), files = [];
  const end = endRecord(view);
  try {
    for (let i = 0, at = end.at; i < end.count; ++i) {
      const entry = entryAt(view, at);
      at = entry.next;
      if (wanted(entry.path)) files.push({ path: entry.path, text: await contents(view, entry) });
    }
  } catch (error) {
    throw error instanceof RangeError || error instanceof TypeError ? new Error("it is damaged") : error;
  }
  return files;
}
