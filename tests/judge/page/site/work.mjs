// A reader's work as a zip: to keep, to hand in, to go on with in another browser. Its paths are the
// course's own: exercises/04_quaternions/product.cpp.
import { allWork, replaceText } from "./store.mjs";
import { writeZip, readZip } from "./zip.mjs";
import { units } from "./course.mjs";

const suffix = ".cpp";

/** Work by whether its text is the stub: {written, untouched}. */
async function sorted() {
  const stubs = new Map((await units()).map((unit) => [unit.id, unit.stub]));
  const isWritten = ({ id, text }) => text !== null && text !== stubs.get(id);
  const all = await allWork();
  return { written: all.filter(isWritten), untouched: all.filter((each) => !isWritten(each)) };
}

/** What was written: units whose text is not the stub. */
export async function written() {
  return (await sorted()).written;
}

/** What has passed once, and is the stub again. */
export async function resetSince() {
  return (await sorted()).untouched.filter(({ right }) => right);
}

export async function workAsZip() {
  return writeZip((await written()).map(({ id, text }) => ({ path: `exercises/${id}${suffix}`, text })));
}

/** The unit that a path in a zip means: its last two parts, whatever folder they are in. */
function unitOf(path) {
  const parts = path.replaceAll("\\", "/").split("/");
  return parts.length >= 2 && path.endsWith(suffix) && !path.startsWith("__MACOSX/")
    ? parts.slice(-2).join("/").slice(0, -suffix.length)
    : "";
}

/** [{id, text, replaces}] of a zip: `replaces` where another text of one's own is there. */
export async function workIn(buffer) {
  const known = new Set((await units()).map((unit) => unit.id));
  const files = await readZip(buffer, (path) => known.has(unitOf(path)));
  if (files.length === 0)
    throw new Error("it has no exercise in it, such as exercises/04_quaternions/product.cpp");
  const mine = new Map((await written()).map(({ id, text }) => [id, text]));
  return files.map(({ path, text }) => {
    const id = unitOf(path);
    return { id, text, replaces: mine.has(id) && mine.get(id) !== text };
  });
}

export async function takeOver(files) {
  for (const { id, text } of files) await replaceText(id, text);
}
