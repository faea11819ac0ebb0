// The folder that a site serves: small files as they are, large ones packed.
import { createHash } from "node:crypto";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { basename, dirname, join, relative } from "node:path";

/** The entries of a tree {name: tree or bytes}, folders before what is in them. */
function entriesOf(tree, above = "") {
  return Object.entries(tree).flatMap(([name, content]) => {
    const path = above + name;
    if (content instanceof Uint8Array) return [{ name: path, data: content }];
    return [{ name: path }, ...entriesOf(content, `${path}/`)];
  });
}

/** A tree as a tar, the same for the same tree. */
export function writeTar({ createTar }, file, tree) {
  writeFileSync(file, createTar(entriesOf(tree), { attrs: { mtime: 0 } }));
}

function filesBelow(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesBelow(path) : [path];
  });
}

/** What a student downloads before the first verdict of a chapter, beside the page. */
const isLarge = (path) => /\.(wasm|tar)$/.test(path);

class Site {
  constructor(folder, level) {
    this.folder = folder;
    this.level = level;
    this.packed = [];
    rmSync(folder, { recursive: true, force: true });
  }

  add(from, to) {
    const target = join(this.folder, to);
    mkdirSync(dirname(target), { recursive: true });
    if (!isLarge(to)) return cpSync(from, target, { recursive: true, dereference: true });
    execFileSync("zstd", ["-q", "-f", `-${this.level}`, "-T0", from, "-o", `${target}.zst`]);
    this.packed.push({ path: to, bytes: statSync(from).size, wire: statSync(`${target}.zst`).size });
  }

  write(name, json) {
    writeFileSync(join(this.folder, name), JSON.stringify(json, null, 1) + "\n");
  }

  /** A name for exactly these files. */
  version() {
    const hash = createHash("sha256");
    for (const path of filesBelow(this.folder).sort()) hash.update(relative(this.folder, path)).update(readFileSync(path));
    return hash.digest("hex").slice(0, 16);
  }
}

const editor = ["lib/codemirror.js", "lib/codemirror.css", "mode/clike/clike.js", "addon/edit/matchbrackets.js", "addon/edit/closebrackets.js"];

/**
 * Everything under one folder, and manifest.json about it, which is given back.
 * @param engine whether there is one that figures can ask
 */
export function writeSite(folder, { root, judge, modules, compiler, units, engine, level }) {
  const site = new Site(folder, Number(level || 19));
  site.add(join(root, "tests/judge/page/site"), ".");
  site.add(join(modules, "fzstd/esm/index.mjs"), "fzstd.mjs");
  site.add(join(modules, "nanotar/dist/index.mjs"), "nanotar.mjs");
  for (const file of editor) site.add(join(modules, "codemirror", file), `codemirror/${basename(file)}`);
  for (const file of readdirSync(compiler)) if (/\.(js|json|wasm|tar)$/.test(file)) site.add(join(compiler, file), `compiler/${file}`);
  for (const file of readdirSync(judge)) if (/^judge_[0-9]+\.(mjs|wasm)$/.test(file)) site.add(join(judge, file), `judge/${file}`);
  for (const { id } of units) site.add(join(root, "solutions", `${id}.cpp`), `solutions/${id}.cpp`);
  site.write("units.json", units);
  const total_wire = site.packed.reduce((sum, each) => sum + each.wire, 0);
  const manifest = { version: site.version(), files: site.packed, total_wire, engine };
  site.write("manifest.json", manifest);
  return manifest;
}
