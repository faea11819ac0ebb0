// Makes the folder that a site serves as exercises/: the compiler, what it needs, the judge, the page's
// scripts. Everything that is large is packed, and named with its size in manifest.json.
//
//   node make.mjs --judge BUILT_JUDGE --out FOLDER [--level 1..19]
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { Clang } from "./clang.mjs";
import { describe } from "./course.mjs";
import { writeSite, writeTar } from "./package.mjs";
import { figureObjects, libraries, unitObjects } from "./runtime.mjs";
import { assertionHandler, contractsTree, eigenTree, isNeeded, put, treeOf } from "./sysroot.mjs";

const { values: options } = parseArgs({
  options: {
    root: { type: "string", default: join(dirname(fileURLToPath(import.meta.url)), "../../../..") },
    judge: { type: "string" },
    out: { type: "string" },
    level: { type: "string" }, // of zstd
  },
});
for (const needed of ["judge", "out"]) if (!options[needed]) throw new Error(`make.mjs needs --${needed}`);
const { root, out } = options;
const brought = join(resolve(options.judge), "headers"); // Eigen and JSON, as the judge was compiled with
const emscripten = execFileSync("em-config", ["EMSCRIPTEN_ROOT"], { encoding: "utf8" }).trim();
const here = join(root, "tests/judge/page");

// As the judge compiles a student's file (tests/judge/student.cmake), with clang's names for the same.
const flags = [
  ...["-std=c++20", "-O1", "-fwasm-exceptions", "-ffp-contract=off", "-fno-finite-loops", "-ftrivial-auto-var-init=pattern"],
  ...["-DEIGEN_DONT_VECTORIZE", "-DEIGEN_INITIALIZE_MATRICES_BY_NAN"],
  ...["-D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_EXTENSIVE"],
  ...["-Wall", "-Wextra", "-Wno-unused-parameter", "-Werror=return-type", "-isystem", "/usr/include/eigen3"],
];
const precompiled = ["-include-pch", "/tumble/precompiled.pch"];
const linked = [
  ...["-fwasm-exceptions", "-mexec-model=reactor", "-Wl,--max-memory=536870912", "-Wl,-z,stack-size=8388608"],
  ...["-Wl,--stack-first", "-Wl,--allow-multiple-definition", "-Wl,--export=main", "-Wl,--strip-all"],
];

const began = Date.now();
function step(text) {
  process.stderr.write(`exercises: ${text} (after ${((Date.now() - began) / 1000).toFixed(0)} s)\n`);
}

/** npm's packages, exactly those of the lock file. */
function install(folder) {
  mkdirSync(folder, { recursive: true });
  for (const file of ["package.json", "package-lock.json"]) cpSync(join(here, "build", file), join(folder, file));
  execFileSync("npm", ["ci", "--no-audit", "--no-fund", "--ignore-scripts"], { cwd: folder, stdio: ["ignore", "ignore", "inherit"] });
  return join(folder, "node_modules");
}

/** The compiler with its own files cut to what is needed, and with Eigen. */
function cutCompiler(modules, tar, folder) {
  const generated = join(modules, "@yowasp/clang/gen");
  rmSync(folder, { recursive: true, force: true });
  cpSync(generated, folder, { recursive: true });
  const all = join(folder, "all"); // its files
  mkdirSync(all);
  execFileSync("tar", ["xf", join(generated, "llvm-resources.tar"), "-C", all]);
  const usr = treeOf(all, isNeeded);
  usr.include.eigen3 = eigenTree(brought);
  put(usr, "include/c++/v1/__assertion_handler", assertionHandler);
  rmSync(all, { recursive: true });
  writeTar(tar, join(folder, "llvm-resources.tar"), usr);
  return pathToFileURL(join(folder, "bundle.js")).href;
}

/** The header that every student's file starts from, and which headers it has seen. */
async function precompile(clang) {
  clang.tree.tumble["precompiled.hpp"] = readFileSync(join(root, "tests/judge/build/precompiled.hpp"));
  const args = [...flags, "-x", "c++-header", "-fpch-instantiate-templates", "-MD", "-MF", "rule", "/tumble/precompiled.hpp"];
  // A file would be copied whole with each piece that is written to it: minutes for these megabytes.
  const { made, written } = await clang.run([...args, "-o", "-"], {});
  const headers = new TextDecoder().decode(made.rule).replaceAll("\\\n", " ").split(/\s+/).slice(1);
  return { pch: written, headers: headers.filter((each) => each) };
}

/** The words of a command without those that name its files. */
function withoutFiles(words, ...named) {
  const dropped = new Set();
  words.forEach((word, i) => {
    if (named.includes(word)) dropped.add(i).add(i + 1);
  });
  return words.filter((_, i) => !dropped.has(i));
}

/** How a file is compiled and linked in the page, step by step without clang's driver. */
async function recipe(clang, units, headers, objects) {
  const source = { "x.cpp": "int main() { return 0; }" };
  const compile = await clang.command([...flags, ...precompiled, "-c", "x.cpp", "-o", "x.o"], source);
  const link = await clang.command([...linked, "x.o", "-o", "x.wasm"], { "x.o": "" });
  const place = link.indexOf("x.o");
  // Beside a header that every file sees, all others of the C library (build/inspection.cpp); of Eigen none.
  const ofC = headers.filter((each) => each.startsWith("/usr/include/") && !each.includes("/Eigen/"));
  return {
    units: units.map((unit) => unit.id),
    compile: withoutFiles(compile, "-main-file-name", "-o", "-x").filter((word) => word !== "x.cpp"),
    link: link.slice(0, place),
    libraries: [...objects.map((each) => `/tumble/libraries/${each}`), ...withoutFiles(link.slice(place + 1), "-o")],
    headers,
    folders: [...new Set(ofC.map((each) => each.slice(0, each.lastIndexOf("/") + 1)))],
    trees: ["/usr/include/c++/v1/", "/tumble/exercises/"],
  };
}

async function main() {
  step("installing the compiler");
  const modules = install(join(out, "npm"));
  const tar = await import(pathToFileURL(join(modules, "nanotar/dist/index.mjs")).href);
  const llvm = await import(cutCompiler(modules, tar, join(out, "compiler")));
  await llvm.runLLVM(null, {}, { fetchProgress: () => {} }); // loads it, runs nothing
  const units = await describe(resolve(options.judge));
  const tree = { exercises: contractsTree(join(root, "exercises")) };
  const clang = new Clang(llvm, { tumble: tree });
  step("compiling what every file starts from");
  const { pch, headers } = await precompile(clang);
  tree["precompiled.pch"] = pch;
  step("compiling the worker");
  const paths = { root, emscripten, nlohmann: join(brought, "nlohmann"), units, flags };
  tree.libraries = await libraries(clang, paths);
  step(`compiling the solutions of ${units.length} units`);
  const steps = await recipe(clang, units, headers, Object.keys(tree.libraries));
  const objects = await unitObjects(llvm, steps, tree, paths);
  const chapters = Object.keys(tree.exercises).filter((each) => /^[0-9]/.test(each));
  const engine = chapters.every((chapter) => units.some((unit) => unit.chapter === chapter)); // figures need all of them
  if (engine) Object.assign(objects, await figureObjects(clang, paths));
  for (const [name, bytes] of Object.entries(objects)) put(tree, `objects/${name}`, bytes);

  step("packing");
  const compiler = join(out, "compiler");
  writeTar(tar, join(compiler, "tumble.tar"), tree);
  writeFileSync(join(compiler, "recipe.json"), JSON.stringify(steps));
  const { total_wire: bytes } = writeSite(join(out, "exercises"), { ...options, modules, compiler, units, engine });
  step(`${join(out, "exercises")}: at most ${(bytes / 1e6).toFixed(1)} MB over the wire, once`);
}

await main();
