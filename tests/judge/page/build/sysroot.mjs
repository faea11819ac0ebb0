// The files that the compiler finds in the page: its own headers and libraries, Eigen, the contracts.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

/** A folder as a tree {name: tree or bytes}, with those of its files that are wanted. */
export function treeOf(folder, wanted = () => true) {
  const tree = {};
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) tree[entry.name] = treeOf(path, wanted);
    else if (wanted(path)) tree[entry.name] = readFileSync(path);
  }
  return tree;
}

/** Puts `bytes` into a tree, at a path from its root. */
export function put(tree, path, bytes) {
  const names = path.split("/").filter((name) => name);
  const file = names.pop();
  for (const name of names) tree = tree[name] ??= {};
  tree[file] = bytes;
}

// Headers of other machines, and of other languages: two thirds of what the compiler brings along.
const elsewhere = [
  /\/c\+\+\/v1\/__cxx03\//,
  /\/include\/(cuda_wrappers|fuzzer|hlsl|llvm_libc_wrappers|llvm_offload_wrappers|openmp_wrappers|orc|ppc_wrappers|profile|sanitizer|zos_wrappers)\//,
  /\/include\/[a-z0-9_]*(intrin|intr|neon|altivec|opencl|cuda|hip|hexagon|riscv|hlsl|sve|sme|vecintrin|velintrin_gen|velintrin_approx|arm_|msa|amo|htmx)[a-z0-9_-]*\.h$/,
];

/** Whether the compiler needs this file of its own, for a student's file. */
export function isNeeded(path) {
  if (/\/lib\//.test(path)) return /\/(libc|libc\+\+|libc\+\+abi|libclang_rt\.builtins)\.a$|\/crt1-reactor\.o$/.test(path);
  return /\/include\//.test(path) && !elsewhere.some((each) => each.test(path));
}

/** What the C++ library does where an index is out of range: its own header stops without a word. */
export const assertionHandler = Buffer.from(`#pragma once
#include <__config>
#include <__verbose_abort>
#define _LIBCPP_ASSERTION_HANDLER(message) _LIBCPP_VERBOSE_ABORT("%s", message)
`);

// In the compiler's file system a path that goes up from a header's folder is not found: `tree` with
// paths from its root instead.
function withPathsFromRoot(tree, path = []) {
  const root = path.slice(0, -1).map((name) => `${name}/`).join("");
  const rewritten = (bytes) =>
    Buffer.from(bytes.toString("utf8").replace(/^(\s*#\s*include\s*)"\.\.\//gm, (_, include) => `${include}"${root}`));
  return Object.fromEntries(
    Object.entries(tree).map(([name, content]) => [
      name,
      content instanceof Uint8Array ? rewritten(content) : withPathsFromRoot(content, [...path, name]),
    ]),
  );
}

/** Eigen's headers as a tree, from the folder that holds Eigen/Core. */
export function eigenTree(folder) {
  if (!existsSync(join(folder, "Eigen/Core"))) throw new Error(`no Eigen in ${folder}: Eigen/Core is missing`);
  return withPathsFromRoot({ Eigen: treeOf(join(folder, "Eigen")) });
}

/** What the contracts of all chapters are made of. */
export function contractsTree(exercises) {
  const tree = { "not_implemented.hpp": readFileSync(join(exercises, "not_implemented.hpp")) };
  for (const chapter of readdirSync(exercises))
    if (/^[0-9]+_/.test(chapter)) tree[chapter] = treeOf(join(exercises, chapter), (path) => path.endsWith(".hpp"));
  return withPathsFromRoot(tree);
}
