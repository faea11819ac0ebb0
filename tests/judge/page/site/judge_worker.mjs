/// @file
/// The Web Worker of the judge: requests in, questions' places and verdicts out.

import { Assets, manifest } from "./assets.mjs";
import { Judges } from "./judge.mjs";

let hear = () => {};
const assets = manifest().then((about) => new Assets(about, (progress) => hear(progress)));

const judges = new Judges(async (digits) => {
  const [{ default: factory }, wasm] = await Promise.all([
    import(`./judge/judge_${digits}.mjs`),
    assets.then((all) => all.response(`judge/judge_${digits}.wasm`)).then((response) => WebAssembly.compileStreaming(response)),
  ]);
  return { factory, wasm };
});

onmessage = async ({ data: { id, ...request } }) => {
  hear = (progress) => postMessage({ id, progress });
  try {
    postMessage({ id, verdict: await judges.judgeUnit(request, (at) => postMessage({ id, at })) });
  } catch (error) {
    postMessage({ id, failure: String(error?.message ?? error) });
  }
};
