/// @file
/// One instance of a student's module, and the system that it sees: text goes out, frames go in and
/// out, the clock ticks. Everything else is refused and ends it. The judge's memory is another
/// instance's: the student's cannot name it.

/// What ends the student's code from inside a call of its own. It must not be able to go on.
class Ended extends Error {}

const badDescriptor = 8, cannotSeek = 70, success = 0;
const answers = 3, questions = 4;
/// WASI's wasi-libc opens a file only below a folder that it was given: so that it asks for the file,
/// and is refused, descriptor 3 seems to be one.
const folder = 3, folderName = '/';

/// The signal that a process would have had, by what engines say of a trap.
const signals = [
  ['SIGFPE', /divi(de|sion) by zero|integer overflow|unrepresentable/i],
  ['SIGILL', /unreachable/i],
  ['SIGSEGV', /out of bounds|null function|signature|call_indirect|indirect call|table/i],
];

function signalOf(error) {
  if (error instanceof WebAssembly.Exception) return 'SIGABRT'; // caught by nobody
  if (error instanceof RangeError || /recursion|stack/i.test(error.message)) return 'SIGSEGV';
  return signals.find(([, words]) => words.test(error.message))?.[0] ?? 'SIGSEGV';
}

const isTrap = error =>
  error instanceof WebAssembly.RuntimeError || error instanceof WebAssembly.Exception ||
  error instanceof RangeError || error?.name === 'InternalError';

export class Student {
  #ending = null;
  #judge;
  #exports;

  /// @param judge {wrote(descriptor, bytes) → may it go on?, reads(most) → bytes}
  constructor(module, judge) {
    this.#judge = judge;
    this.#module = module;
  }
  #module;

  /// Answers the one question that waits.
  /// @return {how, detail?, status?} as page_worker.hpp has it
  answer() {
    try {
      if (!this.#exports) this.#start();
      const main = this.#exports.main ?? this.#exports.__main_argc_argv ?? this.#exports.__main_void;
      main(0, 0);
      return {how: 'returned'};
    } catch (error) {
      return this.#ending ?? this.#endingBy(error);
    }
  }

  #start() {
    this.#exports = new WebAssembly.Instance(this.#module, this.#imports()).exports;
    this.#exports._initialize?.();
  }

  #endingBy(error) {
    if (error instanceof WebAssembly.LinkError) return {how: 'refused', detail: error.message};
    if (isTrap(error)) return {how: 'signal', detail: signalOf(error)};
    return {how: 'failed', detail: String(error?.stack ?? error)};
  }

  /// Ends the student's code; destructors that run meanwhile come to nothing.
  #end(ending) {
    this.#ending ??= ending;
    throw new Ended();
  }

  #imports() {
    const system = {...this.#system(), abort: () => this.#end({how: 'signal', detail: 'SIGABRT'})};
    // The names are the student's: "__proto__" and "constructor" name nothing here.
    const imports = Object.create(null);
    for (const {module, name} of WebAssembly.Module.imports(this.#module)) {
      const refuse = () => this.#end({how: 'refused', detail: name});
      const call = Object.hasOwn(system, name) ? system[name] : refuse;
      (imports[module] ??= Object.create(null))[name] = (...values) => {
        if (this.#ending) throw new Ended();
        return call(...values);
      };
    }
    return imports;
  }

  // ── Its memory ──
  get #view() { return new DataView(this.#exports.memory.buffer); }
  #bytes(at, size) { return new Uint8Array(this.#exports.memory.buffer, at >>> 0, size >>> 0); }
  #store(at, ...words) {
    words.forEach((word, i) => this.#view.setUint32((at >>> 0) + 4 * i, word, true));
    return success;
  }
  /// The parts of memory that a list of (address, size) names.
  #parts(list, count) {
    const view = this.#view;
    return Array.from({length: count}, (_, i) => {
      const at = (list >>> 0) + 8 * i;
      return [view.getUint32(at, true), view.getUint32(at + 4, true)];
    });
  }

  // ── Its system ──
  #system() {
    return {
      fd_write: (descriptor, list, count, written) => this.#write(descriptor, list, count, written),
      fd_read: (descriptor, list, count, read) => this.#read(descriptor, list, count, read),
      fd_seek: () => cannotSeek,
      fd_tell: () => cannotSeek,
      fd_sync: () => success,
      fd_fdstat_get: (descriptor, at) => this.#describe(descriptor, at),
      fd_fdstat_set_flags: () => success,
      fd_prestat_get: (descriptor, at) =>
        descriptor === folder ? this.#store(at, 0, folderName.length) : badDescriptor,
      fd_prestat_dir_name: (_, at) => {
        this.#bytes(at, 1)[0] = folderName.charCodeAt(0);
        return success;
      },
      environ_sizes_get: (count, size) => this.#store(count, 0) || this.#store(size, 0),
      environ_get: () => success,
      args_sizes_get: (count, size) => this.#store(count, 0) || this.#store(size, 0),
      args_get: () => success,
      clock_time_get: (clock, _, at) => this.#tell(at, clock === 0 ? Date.now() : performance.now()),
      clock_res_get: (_, at) => this.#tell(at, 1),
      random_get: (at, size) => this.#fillRandom(at, size),
      sched_yield: () => success,
      proc_exit: status => this.#end({how: 'exited', status: status & 0xff}),
    };
  }

  #write(descriptor, list, count, written) {
    if (![1, 2, answers].includes(descriptor)) return badDescriptor;
    let size = 0;
    for (const [at, length] of this.#parts(list, count)) {
      if (!this.#judge.wrote(descriptor, this.#bytes(at, length))) this.#end({how: 'stopped'});
      size += length;
    }
    return this.#store(written, size);
  }

  #read(descriptor, list, count, read) {
    if (descriptor !== 0 && descriptor !== questions) return badDescriptor;
    let size = 0;
    for (const [at, length] of descriptor === questions ? this.#parts(list, count) : []) {
      const bytes = this.#judge.reads(length);
      this.#bytes(at, bytes.length).set(bytes);
      size += bytes.length;
    }
    return this.#store(read, size);
  }

  #describe(descriptor, at) {
    if (descriptor > questions) return badDescriptor;
    const isFolder = descriptor === folder;
    this.#bytes(at, 24).fill(0);
    this.#view.setUint8(at >>> 0, isFolder ? 3 : 6); // a folder; or a stream, and no terminal
    this.#bytes(at + 8, 16).fill(0xff);              // every right
    return success;
  }

  #tell(at, milliseconds) {
    this.#view.setBigUint64(at >>> 0, BigInt(Math.round(milliseconds * 1e6)), true);
    return success;
  }

  #fillRandom(at, size) {
    const most = 65536; // of getRandomValues
    for (let done = 0; done < size; done += most)
      crypto.getRandomValues(this.#bytes(at + done, Math.min(most, size - done)));
    return success;
  }
}
