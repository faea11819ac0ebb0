// The page's compiler, while the site is made.
/** The words of the commands that clang's driver would run: "-###" prints one a line. */
function commandsOf(text) {
  const lines = text.split("\n").filter((line) => line.startsWith(' "'));
  return lines.map((line) => [...line.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map((word) => word[1]).filter((word) => word));
}

export class Clang {
  /**
   * @param llvm the module of @yowasp/clang
   * @param tree what all its files see below /: {tumble: {…}}; who adds to it, adds for later runs
   */
  constructor(llvm, tree) {
    this.llvm = llvm;
    this.tree = tree;
  }

  /** The files after clang has run with these arguments, what it said, and what it wrote to "-". */
  async run(args, files) {
    const heard = { stdout: [], stderr: [] };
    const listen = (to) => (bytes) => bytes && to.push(bytes.slice());
    const said = () => Buffer.concat(heard.stderr).toString("utf8");
    const options = { stdout: listen(heard.stdout), stderr: listen(heard.stderr), decodeASCII: false, fetchProgress: () => {} };
    try {
      const made = await this.llvm.runClang(["clang++", ...args], { ...this.tree, ...files }, options);
      return { made, said: said(), written: Buffer.concat(heard.stdout) };
    } catch (failure) {
      throw new Error(`clang++ ${args.join(" ")}\n${said()}${failure.message}`);
    }
  }

  async object(args, files) {
    const { made } = await this.run([...args, "-c", "-o", "object.o"], files);
    return made["object.o"];
  }

  /** The words of the one command that the driver would run for a step. */
  async command(args, files) {
    const { said } = await this.run(["-###", ...args], files);
    return commandsOf(said)[0];
  }
}
