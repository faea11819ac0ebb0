// A Web Worker: from a student's file to a module, with clang.
import { Assets, manifest } from "./assets.mjs";
import { parseTar } from "./nanotar.mjs";
import { EngineBuilder } from "./engine_builder.mjs";
import { Toolchain } from "./toolchain.mjs";

/** The compiler fetches its files by itself: the large ones come unpacked from where they are kept. */
function fetchThrough(assets) {
  const fetchOther = globalThis.fetch.bind(globalThis);
  const large = new Map(assets.about.files.map(({ path }) => [assets.address(path), path]));
  globalThis.fetch = (resource, options) => {
    const path = large.get(resource.href ?? resource);
    return path ? assets.response(path) : fetchOther(resource, options);
  };
}

/** A tar as a tree {name: tree or bytes}. */
function treeOfTar(bytes) {
  const root = {};
  for (const { name, type, data } of parseTar(bytes.buffer)) {
    const names = name.split("/");
    const last = names.pop();
    const folder = names.reduce((tree, each) => tree[each], root);
    folder[last] = type === "directory" ? {} : data;
  }
  return root;
}

async function load(hear) {
  const assets = new Assets(await manifest(), hear);
  await assets.expect("compiler");
  const recipe = fetch(new URL("compiler/recipe.json", import.meta.url)).then((response) => response.json());
  const tree = treeOfTar(await assets.bytes("compiler/tumble.tar"));
  fetchThrough(assets);
  const llvm = await import("./compiler/bundle.js");
  await llvm.runLLVM(null, {}, { fetchProgress: () => {} }); // fetches what it needs, runs nothing
  const toolchain = new Toolchain(llvm, await recipe, tree);
  return { toolchain, engines: new EngineBuilder(toolchain) };
}

let tools;
let listener = () => {};

/** What is asked for: a unit's module, or an engine of several files. */
function build({ toolchain, engines }, { unit, source, engine }) {
  return unit ? toolchain.build(unit, source) : engines.build(engine.topic, engine.files);
}

onmessage = async ({ data: { id, ...request } }) => {
  listener = (progress) => postMessage({ id, progress });
  try {
    tools ??= load((progress) => listener(progress));
    const loaded = await tools;
    postMessage({ id, compiling: true }); // from now on the page counts
    const began = performance.now();
    const built = await build(loaded, request);
    postMessage({ id, built: { ...built, seconds: (performance.now() - began) / 1000 } });
  } catch (failure) {
    tools = undefined; // a download that was broken off begins again
    postMessage({ id, failure: String(failure.message ?? failure) });
  }
};
