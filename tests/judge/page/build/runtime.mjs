// What a student's module is linked with, compiled by the compiler that the page has: the worker, the
// part of the C++ library that is about exceptions, and what calls each unit's function.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { Toolchain } from "../site/toolchain.mjs";
import { treeOf } from "./sysroot.mjs";

// The compiler's own libc++abi has no exceptions. These files of it have; emscripten brings them.
const exceptions = ["cxa_exception", "cxa_exception_storage", "cxa_personality"];

/** The sources of the exceptions, from emscripten's folder of system libraries. */
function exceptionSources(libraries) {
  const unwind = join(libraries, "libunwind");
  return {
    // Both expect headers of their own build; without threads and tracing these are empty.
    empty: {
      __threading_support: "",
      "config.h": "#define _LIBUNWIND_EXPORT\n#define _LIBUNWIND_HIDDEN\n#define _LIBUNWIND_TRACE_API(...)\n#define _LIBUNWIND_LOG(...)\n",
    },
    abi: treeOf(join(libraries, "libcxxabi"), (path) => !/\/test/.test(path)),
    unwind: { include: treeOf(join(unwind, "include")), src: { "Unwind-wasm.c": readFileSync(join(unwind, "src/Unwind-wasm.c")) } },
  };
}

const exceptionFlags = [
  ...["-O2", "-fwasm-exceptions", "-DNDEBUG", "-w"],
  ...["-D__USING_WASM_EXCEPTIONS__", "-D__WASM_EXCEPTIONS__", "-D_LIBCPP_BUILDING_LIBRARY"],
  ...["-D_LIBCXXABI_HAS_NO_THREADS", "-D_LIBCXXABI_DISABLE_VISIBILITY_ANNOTATIONS", "-D_LIBCPP_INLINE_VISIBILITY="],
  ...["-I", "empty", "-I", "abi/include", "-I", "unwind/include"],
];

/** The objects of the exceptions. */
async function exceptionObjects(clang, libraries) {
  const sources = exceptionSources(libraries);
  const objects = {};
  for (const name of exceptions)
    objects[`${name}.o`] = await clang.object(["-std=c++20", ...exceptionFlags, `abi/src/${name}.cpp`], sources);
  objects["unwind.o"] = await clang.object(["-x", "c", ...exceptionFlags, "unwind/src/Unwind-wasm.c"], sources);
  return objects;
}

/** What calls the function of a unit. */
function workerOf(root, { chapter, name }) {
  const main = readFileSync(join(root, "tests/judge/worker/main.cpp.in"), "utf8");
  return main.replace("@namespace@", chapter.replace(/^[0-9]+_/, "")).replace("@name@", name);
}

/** The libraries of every module: {name: bytes}. */
export async function libraries(clang, { root, emscripten, nlohmann, flags }) {
  const judge = treeOf(join(root, "tests/judge"), (path) => !/\.cpp$/.test(path) || /(message|serve|runtime)\.cpp$/.test(path));
  const files = { judge, nlohmann: treeOf(nlohmann) };
  const include = ["-I", ".", "-I", "/tumble/exercises"];
  const objects = await exceptionObjects(clang, join(emscripten, "system/lib"));
  for (const source of ["protocol/message", "worker/serve", "page/student/runtime"])
    objects[`${source.split("/").pop()}.o`] = await clang.object([...flags, "-O2", ...include, `judge/${source}.cpp`], files);
  return objects;
}

/** What figures ask engines of a student's functions, by topics: {"figure_motion.o": bytes, …}. */
export async function figureObjects(clang, { root, nlohmann, flags }) {
  const files = { judge: treeOf(join(root, "tests/judge"), (path) => /\.hpp$|figure_\w+\.cpp$/.test(path)), nlohmann: treeOf(nlohmann) };
  const include = ["-I", ".", "-I", "/tumble/exercises"];
  const objects = {};
  for (const source of Object.keys(files.judge.page.student).filter((name) => name.endsWith(".cpp")))
    objects[source.replace(".cpp", ".o")] = await clang.object([...flags, ...include, `judge/page/student/${source}`], files);
  return objects;
}

/** What the compiler has made of a file of ours. */
async function objectOf(toolchain, unit, source) {
  const { ok, output, object } = await toolchain.compile(unit, source);
  if (!ok) throw new Error(`${unit}: ${output}`);
  return object;
}

/**
 * The objects of the units: {"04_quaternions/product.worker.o": bytes, … .solution.o}, compiled as the
 * page compiles.
 */
export async function unitObjects(llvm, recipe, tree, { root, units }) {
  const headers = treeOf(join(root, "tests/judge"), (path) => /\.hpp$/.test(path));
  const withHeaders = { ...recipe, compile: [...recipe.compile, "-I", "/tumble"] };
  const toolchain = new Toolchain(llvm, withHeaders, { ...tree, judge: headers });
  const objects = {};
  for (const unit of units) {
    objects[`${unit.id}.worker.o`] = await objectOf(toolchain, unit.id, workerOf(root, unit));
    const solution = readFileSync(join(root, "solutions", `${unit.id}.cpp`), "utf8");
    objects[`${unit.id}.solution.o`] = await objectOf(toolchain, unit.id, solution);
  }
  return objects;
}
