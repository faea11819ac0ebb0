// What the site's folder of exercises holds: the units, where their boxes are, what a check downloads.
export const base = new URL("./", import.meta.url);

const fetched = {};

/** A JSON file of the folder, asked for once. */
export function json(name) {
  fetched[name] ??= fetch(new URL(name, base), { cache: "no-cache" }).then((response) => {
    if (!response.ok) throw new Error(`${name} cannot be read: ${response.status}`);
    return response.json();
  });
  return fetched[name];
}

export const units = () => json("units.json");
/** chapter → its units, both in the order of the course */
export async function unitsByChapter() {
  const chapters = new Map();
  for (const unit of await units()) chapters.set(unit.chapter, [...(chapters.get(unit.chapter) ?? []), unit]);
  return chapters;
}

/** The unit that follows in the course, if there is one. */
export async function unitAfter({ id }) {
  const all = await units();
  return all[all.findIndex((each) => each.id === id) + 1];
}

export const manifest = () => json("manifest.json");

/** "4.1" → "chapters-04_quaternions.html" */
export const pages = () => json("pages.json");

export async function addressOf(unit) {
  const page = (await pages())[unit.number];
  return page && new URL(`../${page}#now-write-${unit.number}`, base).href;
}

export async function solutionOf(unit) {
  const response = await fetch(new URL(`solutions/${unit.id}.cpp`, base));
  if (!response.ok) throw new Error(`the solution cannot be read: ${response.status}`);
  return response.text();
}
