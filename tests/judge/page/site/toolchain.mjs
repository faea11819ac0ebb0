// From a student's file to a module: compile, and link with the worker and the solutions of earlier
// units. Runs in the page and, while the site is made, in node.

/**
 * What a tool of LLVM said and made.
 * @returns {ok, files, output}, and `limit` if it had no memory or no stack left
 */
async function run(llvm, args, files) {
  let output = "";
  const text = new TextDecoder();
  const hear = (bytes) => {
    if (bytes) output += text.decode(bytes, { stream: true });
  };
  const options = { stdout: hear, stderr: hear, decodeASCII: false, fetchProgress: () => {} };
  try {
    const made = await llvm.runLLVM(args, files, options);
    return { ok: true, files: made, output };
  } catch (failure) {
    return { ok: false, files: failure.files ?? {}, output, limit: !(failure instanceof llvm.Exit) };
  }
}

/** The files of a rule for make, without its target. */
function filesOfRule(bytes) {
  const rule = new TextDecoder().decode(bytes);
  return rule
    .slice(rule.indexOf(":") + 1)
    .replaceAll("\\\n", " ")
    .split(/\s+/)
    .filter((each) => each);
}

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
      ...["-dependency-file", "rule", "-MT", "object", "-sys-header-deps"],
      ...["-main-file-name", `${name}.cpp`, "-o", "object", "-x", "c++", file],
    ];
    const { ok, output, files, limit } = await run(this.llvm, args, { ...this.files, student: { [`${name}.cpp`]: source } });
    const headers = files.rule ? filesOfRule(files.rule) : [];
    return {
      ok,
      output,
      limit,
      headers: headers.filter((each) => each !== file && !this.allows(each)),
      object: files.object,
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
    const { output } = await run(this.llvm, ["nm", "--defined-only", "--extern-only", "--demangle", "object"], { object });
    return [...output.matchAll(/^[0-9a-f]+ T (.+)$/gm)].map((line) => line[1]);
  }
}
