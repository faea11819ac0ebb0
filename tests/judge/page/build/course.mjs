// What there is to write, as the judge's modules say it.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

/** The units of all chapters, in the order of the course. */
export async function describe(judge) {
  const units = [];
  for (const file of readdirSync(judge).sort()) {
    if (!/^judge_[0-9]+\.mjs$/.test(file)) continue;
    const { default: load } = await import(pathToFileURL(join(judge, file)).href);
    const module = await load({ wasmBinary: readFileSync(join(judge, file.replace(".mjs", ".wasm"))) });
    units.push(...JSON.parse(module.describe()).map((unit) => ({ ...unit, id: `${unit.chapter}/${unit.name}` })));
  }
  if (units.length === 0) throw new Error(`there is no judge in ${judge}: judge_01.mjs is missing`);
  return units;
}
