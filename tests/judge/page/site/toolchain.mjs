// From a student's file to a module: compile, and link with the worker and the solutions of earlier
// units. Runs in the page and, while the site is made, in node.
import { joined } from "./bytes.mjs";

/**
 * What a tool of LLVM said and made.
 * @returns {ok, files, written, output}: `written` to its standard output, `output` to the error one;
 *          and `limit` if it had no memory or no stack left
 */
export async function run(llvm, args, files) {
  const heard = { stdout: [], stderr: [] };
  const listen = (to) => (bytes) => bytes && to.push(bytes.slice());
  const options = { stdout: listen(heard.stdout), stderr: listen(heard.stderr), decodeASCII: false, fetchProgress: () => {} };
  const said = () => ({ written: joined(heard.stdout), output: new TextDecoder().decode(joined(heard.stderr)) });
  try {
    const made = await llvm.runLLVM(args, files, options);
    return { ok: true, files: made, ...said() };
  } catch (failure) {
    return { ok: false, files: failure.files ?? {}, ...said(), limit: !(failure instanceof llvm.Exit) };
  }
}

/** What clang lists of a file's headers among its messages, with -H: ". /usr/include/errno.h". */
const listed = /^\.+ (\/.*)\n/gm;

export class Toolchain {
  /**
   * @param llvm   the module of @yowasp/clang
   * @param recipe how a file is compiled and linked: recipe.json, as the site was made
   * @param tree   what the compiler sees below /tumble: contracts, precompiled header, objects
   */
  constructor(llvm, recipe, tree) {
    this.llvm = llvm;
    this.recipe = recipe;
    this.files = { tumble: tree };
  }

  /**
   * @param unit   "04_quaternions/product"
   * @param source the student's file
   * @returns {ok, step: "compile", "link" or "limit", output, headers, functions, wasm}
   */
  async build(unit, source) {
    const compiled = await this.compile(unit, source);
    const step = compiled.limit ? "limit" : "compile";
    if (!compiled.ok) return { ok: false, step, output: compiled.output, headers: compiled.headers, wasm: null };
    const { ok, output, wasm } = await this.link(unit, compiled.object);
    if (ok) return { ok, step, output: compiled.output, headers: compiled.headers, wasm };
    const functions = await this.functionsIn(compiled.object);
    return { ok, step: "link", output, headers: compiled.headers, functions, wasm: null };
  }

  async compile(unit, source) {
    const [chapter, name] = unit.split("/");
    const file = `/student/${name}.cpp`;
    const args = [
      ...this.recipe.compile,
      ...["-I", `/tumble/exercises/${chapter}`, "-I", "/tumble/exercises"],
      ...["-include", `/tumble/exercises/${chapter}/contract.hpp`],
      ...["-H", "-sys-header-deps"], // those that are not precompiled
      // To its standard output: a file is copied whole with each piece that is written to it.
      ...["-main-file-name", `${name}.cpp`, "-o", "-", "-x", "c++", file],
    ];
    const { ok, output, written, limit } = await run(this.llvm, args, { ...this.files, student: { [`${name}.cpp`]: source } });
    const headers = [...output.matchAll(listed)].map(([, header]) => header);
    return {
      ok,
      output: output.replace(listed, ""),
      limit,
      headers: headers.filter((each) => !this.allows(each)),
      object: written,
    };
  }

  /** Whether an exercise may see this header: its contracts, Eigen/Core, the standard libraries of C++ and C. */
  allows(header) {
    const { trees, folders, headers } = this.recipe;
    const folder = header.slice(0, header.lastIndexOf("/") + 1);
    return trees.some((each) => header.startsWith(each)) || folders.includes(folder) || headers.includes(header);
  }

  async link(unit, object) {
    const [chapter, name] = unit.split("/");
    const place = this.recipe.units.indexOf(unit);
    const earlier = this.recipe.units.slice(0, place).map((each) => `/tumble/objects/${each}.solution.o`);
    const args = [
      ...this.recipe.link,
      `/tumble/objects/${chapter}/${name}.worker.o`,
      "object",
      ...earlier,
      ...this.recipe.libraries,
      ...["-o", "module"],
    ];
    const { ok, output, files } = await run(this.llvm, args, { ...this.files, object });
    return { ok, output, wasm: files.module ?? null };
  }

  /** The functions that an object defines, as they are declared: "quaternions::prod(double)". */
  async functionsIn(object) {
    const { written } = await run(this.llvm, ["nm", "--defined-only", "--extern-only", "--demangle", "object"], { object });
    return [...new TextDecoder().decode(written).matchAll(/^[0-9a-f]+ T (.+)$/gm)].map((line) => line[1]);
  }
}
