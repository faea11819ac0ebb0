// Judges in the page: a compiler and a judge, each in a Web Worker of its own.

const patience = 2000; // [ms] for one answer, as natively
const patienceWithCompiler = 30000; // [ms] for one file: a hundred times what an exercise takes

/** One worker, and what is being asked of it. */
class Asked {
  constructor(url) {
    this.worker = new Worker(url, { type: "module" });
    this.last = 0;
  }

  /**
   * The message that answers this one.
   * @param hear is called with those before it
   */
  ask(message, hear = () => {}) {
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.fail = reject;
      this.worker.onerror = (event) => reject(new Error(event.message || "a script of the page cannot be loaded"));
      this.worker.onmessage = ({ data }) => {
        if (data.id !== id) return;
        if (data.failure) reject(new Error(data.failure));
        else if ("built" in data || "verdict" in data) resolve(data);
        else hear(data);
      };
      this.worker.postMessage({ ...message, id });
    });
  }

  end() {
    this.worker.terminate();
  }
}

/** A question that has no answer in time. */
class Hung extends Error {
  constructor(at) {
    super("no answer in time");
    this.at = at;
  }
}

/** The reader waits no longer. */
class Stopped extends Error {
  constructor() {
    super("stopped");
  }
}

/** A file that keeps the compiler busy. */
class TooExpensive extends Error {}

export class Judge {
  constructor(base = new URL("./", import.meta.url)) {
    this.base = base;
    this.queue = Promise.resolve();
  }

  /**
   * The verdict on a file: the object that `./tumble check --json` writes of a unit; its `json` is
   * that text.
   * @param unit       "04_quaternions/product"
   * @param seed       of the inputs
   * @param onProgress is called with {done, total} [bytes] while something is downloaded
   */
  check(unit, source, { seed, onProgress = () => {} }) {
    const verdict = this.queue.then(() => this.#check(unit, source, seed, onProgress));
    this.queue = verdict.catch(() => {}); // the next one has its own chance
    return verdict;
  }

  /**
   * A motion by an engine of these files [{id, text}], and of solutions for what they lack:
   * {states, own} or {outcome, detail}.
   * @param question 26 numbers of a figure
   */
  motion(question, files, onProgress = () => {}) {
    const motion = this.queue.then(() => this.#motion(question, files, onProgress));
    this.queue = motion.catch(() => {});
    return motion;
  }

  async #motion(question, engine, onProgress) {
    const { built } = await this.#build({ engine }, onProgress);
    if (!built.ok) return { outcome: "does not link", detail: built.output };
    try {
      const { verdict } = await this.#judge({ question, built }, onProgress);
      return { ...JSON.parse(verdict), own: built.own };
    } catch (failure) {
      if (!(failure instanceof Hung)) throw failure;
      return { outcome: "hung", detail: "no answer in 2 s" };
    }
  }

  /** Ends what is being checked: its promise is broken off. */
  stop() {
    this.asked?.fail(new Stopped());
  }

  /** Downloads what a chapter needs, without judging. */
  async prepare(onProgress = () => {}) {
    await this.#build({}, onProgress);
  }

  async #check(unit, source, seed, onProgress) {
    const began = performance.now();
    const { built } = await this.#build({ unit, source }, onProgress);
    const hung = [];
    for (;;) {
      try {
        const { verdict } = await this.#judge({ unit, source, built, seed, hung }, onProgress);
        return { ...JSON.parse(verdict), json: verdict, seconds: (performance.now() - began) / 1000 };
      } catch (failure) {
        if (!(failure instanceof Hung)) throw failure;
        hung.push(failure.at); // the same again, and this question has no answer
      }
    }
  }

  /** What the compiler has made of a file. If that takes too long, the compiler is ended. */
  async #build(what, onProgress) {
    const compiler = (this.asked = this.compiler ??= new Asked(new URL("compiler.mjs", this.base)));
    let clock;
    const hear = ({ progress, compiling }) => {
      if (progress) onProgress(progress);
      if (compiling) clock = setTimeout(() => compiler.fail(new TooExpensive()), patienceWithCompiler);
    };
    try {
      return await compiler.ask(what, hear);
    } catch (failure) {
      compiler.end();
      this.compiler = null;
      if (failure instanceof TooExpensive) return { built: { ok: false, step: "limit", output: "", headers: [] } };
      throw failure;
    } finally {
      clearTimeout(clock);
    }
  }

  /** One run of a spec. A worker whose student does not answer in time is ended. */
  async #judge(message, onProgress) {
    const judge = (this.asked = this.judge ??= new Asked(new URL("judge.mjs", this.base)));
    let clock;
    const end = (why) => {
      judge.end();
      this.judge = null;
      judge.fail(why);
    };
    const hear = ({ at, progress }) => {
      if (progress) return onProgress(progress);
      clearTimeout(clock);
      if (at) clock = setTimeout(() => end(new Hung(at)), patience);
    };
    try {
      return await judge.ask(message, hear);
    } catch (failure) {
      end(failure);
      throw failure;
    } finally {
      clearTimeout(clock);
    }
  }
}
