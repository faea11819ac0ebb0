/// @file
/// The Web Worker of the judge: requests in; the questions' places, then a verdict out. The page ends
/// it when an answer takes too long.

import {Assets, manifest} from './assets.mjs';
import {Judges} from './judges.mjs';

let hear = () => {};

const assets = manifest().then(about => new Assets(about, progress => hear({progress})));

const judges = new Judges(async digits => {
  const [{default: factory}, response] = await Promise.all([
    import(`./judge/judge_${digits}.mjs`),
    assets.then(all => all.response(`judge/judge_${digits}.wasm`)),
  ]);
  return {factory, wasm: await WebAssembly.compileStreaming(response)};
});

onmessage = async ({data: {id, ...request}}) => {
  hear = message => postMessage({id, ...message});
  try {
    const at = place => hear({at: place});
    hear({verdict: await (request.question ? judges.answerFigure(request, at) : judges.judgeUnit(request, at))});
  } catch (error) {
    hear({failure: String(error?.message ?? error)});
  }
};
