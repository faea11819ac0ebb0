// From a student's file to a module: compile, and link with the worker and the solutions of earlier
// units. Runs in the page and, while the site is made, in node.

/** What a tool of LLVM said and made. */
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
    // A compiler that has crashed says so in the same place as one that has refused the file.
    if (!(failure instanceof llvm.Exit)) output += `the compiler failed: ${failure.message ?? failure}\n`;
    return { ok: false, files: failure.files ?? {}, output };
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
   * @returns {ok, step: "compile" or "link", output, headers, wasm}
   */
  async build(unit, source) {
    const compiled = await this.compile(unit, source);
    if (!compiled.ok) return { ...compiled, step: "compile", wasm: null };
    const linked = await this.link(unit, compiled.object);
    return {
      ok: linked.ok,
      step: linked.ok ? "compile" : "link",
      output: linked.ok ? compiled.output : linked.output,
      headers: compiled.headers,
      wasm: linked.wasm,
    };
  }

  async compile(unit, source) {
    const [chapter, name] = unit.split("/");
    const file = `/student/${name}.cpp`;
    const args = [
      ...this.recipe.compile,
      ...["-I", `/tumble/exercises/${chapter}`, "-I", "/tumble/exercises"],
      ...["-include", `/tumble/exercises/${chapter}/contract.hpp`],
      ...["-dependency-file", "/student/rule", "-MT", "object", "-sys-header-deps"],
      ...["-main-file-name", `${name}.cpp`, "-o", "/student/object", "-x", "c++", file],
    ];
    const done = await run(this.llvm, args, { ...this.files, student: { [`${name}.cpp`]: source } });
    const made = done.files.student ?? {};
    const headers = made.rule ? filesOfRule(made.rule) : [];
    return {
      ok: done.ok,
      output: done.output,
      headers: headers.filter((each) => each !== file && !this.allows(each)),
      object: made.object,
    };
  }

  /** Whether an exercise may see this header: its contracts, Eigen/Core, the standard library. */
  allows(header) {
    return this.recipe.folders.some((each) => header.startsWith(each)) || this.recipe.headers.includes(header);
  }

  async link(unit, object) {
    const [chapter, name] = unit.split("/");
    const place = this.recipe.units.indexOf(unit);
    const earlier = this.recipe.units.slice(0, place).map((each) => `/tumble/objects/${each}.solution.o`);
    const args = [
      ...this.recipe.link,
      `/tumble/objects/${chapter}/${name}.worker.o`,
      "/student/object",
      ...earlier,
      ...this.recipe.libraries,
      ...["-o", "/student/module"],
    ];
    const done = await run(this.llvm, args, { ...this.files, student: { object } });
    return { ok: done.ok, output: done.output, wasm: done.files.student?.module ?? null };
  }
}
