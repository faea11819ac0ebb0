// What there is to write, as the judge's modules say it.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { ChapterJudge } from "../site/judges.mjs";

/** The units of all chapters, in the order of the course. */
export async function describe(judge) {
  const units = [];
  for (const file of readdirSync(judge).sort()) {
    if (!/^judge_[0-9]+\.mjs$/.test(file)) continue;
    const { default: factory } = await import(pathToFileURL(join(judge, file)).href);
    const wasm = new WebAssembly.Module(readFileSync(join(judge, file.replace(".mjs", ".wasm"))));
    units.push(...(await ChapterJudge.start(factory, wasm)).describe());
  }
  if (units.length === 0) throw new Error(`there is no judge in ${judge}: judge_01.mjs is missing`);
  return units;
}
