/// @file
/// The Web Worker of the judge: requests in, questions' places and verdicts out.

import {Judges} from './judge.mjs';

const judges = new Judges(async digits => {
  const [{default: factory}, wasm] = await Promise.all([
    import(`./judge_${digits}.mjs`),
    WebAssembly.compileStreaming(fetch(new URL(`judge_${digits}.wasm`, import.meta.url))),
  ]);
  return {factory, wasm};
});

onmessage = async ({data: {id, ...request}}) => {
  try {
    postMessage({id, verdict: await judges.judgeUnit(request, at => postMessage({id, at}))});
  } catch (error) {
    postMessage({id, failure: String(error?.message ?? error)});
  }
};
