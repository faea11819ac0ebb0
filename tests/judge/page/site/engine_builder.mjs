// One engine of a reader's functions, for figures that ask them: what the engine needs comes from the
// reader's files, and from solutions where there is none.
import { run } from "./toolchain.mjs";

/** What the linker lacks: "undefined symbol: rigid_body::simulate(…". */
const lacks = /undefined symbol: (\w+)::(\w+)/g;

export class EngineBuilder {
  constructor(toolchain) {
    this.toolchain = toolchain;
    this.compiled = new Map(); // unit → its text and object
  }

  /** The engine of these files [{id, text}]: {ok, output, wasm, own: the units of them that it uses}. */
  async build(topic, files) {
    const texts = new Map(files.map(({ id, text }) => [id, text]));
    const parts = new Map(); // unit → what is linked
    const own = [];
    for (;;) {
      const { ok, output, wasm } = await this.link(topic, parts);
      const needed = ok ? [] : this.lacking(output).filter((unit) => !parts.has(unit));
      if (needed.length === 0) return { ok, output, wasm, own };
      for (const unit of needed) {
        const object = texts.has(unit) && (await this.objectOf(unit, texts.get(unit)));
        parts.set(unit, object);
        if (object) own.push(unit);
      }
    }
  }

  /** The units whose functions a linker has not found. */
  lacking(output) {
    const names = new Set([...output.matchAll(lacks)].map(([, chapter, name]) => `${chapter}/${name}`));
    return this.toolchain.recipe.units.filter((unit) => names.has(unit.replace(/^[0-9]+_/, "")));
  }

  /** @param parts unit → the reader's object, or nothing: then it is the solution's */
  async link(topic, parts) {
    const { recipe, files, llvm } = this.toolchain;
    const own = Object.fromEntries([...parts.values()].filter((object) => object).map((object, i) => [`own${i}.o`, object]));
    const solutions = [...parts].filter(([, object]) => !object).map(([unit]) => `/tumble/objects/${unit}.solution.o`);
    const objects = [`/tumble/objects/figure_${topic}.o`, ...Object.keys(own), ...solutions];
    const args = [...recipe.link, "--error-limit=0", ...objects, ...recipe.libraries, "-o", "module"];
    const linked = await run(llvm, args, { ...files, ...own });
    return { ok: linked.ok, output: linked.output, wasm: linked.files.module ?? null };
  }

  /** What the compiler makes of a reader's file; nothing if it isn't one for a judge. */
  async objectOf(unit, text) {
    const known = this.compiled.get(unit);
    if (known?.text === text) return known.object;
    const { ok, headers, object } = await this.toolchain.compile(unit, text);
    const whole = ok && headers.length === 0 ? object : null;
    this.compiled.set(unit, { text, object: whole });
    return whole;
  }
}
