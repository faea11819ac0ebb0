// What a reader has written, and how far they are: in this browser's IndexedDB, and nowhere else.
// A unit's record: {id, text, checked, old: [{text, at}], passed, tries, hints, last}.
const mostOld = 20;
const channel = "BroadcastChannel" in globalThis ? new BroadcastChannel("tumble-work") : null;
let opened = null;

function openDatabase() {
  opened ??= new Promise((resolve, reject) => {
    const request = indexedDB.open("tumble-exercises", 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore("work", { keyPath: "id" });
      request.result.createObjectStore("settings");
    };
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
  return opened;
}

/** Runs `use` on one table; the promise is of what its request gives, once that is on disk. */
async function transact(table, mode, use) {
  const transaction = (await openDatabase()).transaction(table, mode);
  return new Promise((resolve, reject) => {
    const result = use(transaction.objectStore(table));
    transaction.oncomplete = () => resolve(result?.result);
    transaction.onerror = transaction.onabort = () => reject(transaction.error);
  });
}

const untouched = (id) => ({
  id, text: null, checked: null, right: null, old: [], passed: false, tries: 0, hints: 0, last: null,
});

/** Reads a record, changes it and writes it back, with no other tab between. */
async function change(id, edit) {
  const written = await transact("work", "readwrite", (table) => {
    const read = table.get(id);
    const holder = {};
    read.onsuccess = () => {
      holder.result = read.result ?? untouched(id);
      edit(holder.result);
      table.put(holder.result);
    };
    return holder;
  });
  channel?.postMessage({ id });
  return written;
}

function keepOld(record, text) {
  if (text === null || record.old[0]?.text === text) return;
  record.old = [{ text, at: Date.now() }, ...record.old.filter((each) => each.text !== text)];
  record.old.length = Math.min(record.old.length, mostOld);
}

export async function workOn(id) {
  return (await transact("work", "readonly", (table) => table.get(id))) ?? untouched(id);
}

export function allWork() {
  return transact("work", "readonly", (table) => table.getAll());
}

/**
 * Writes a text. `base` is the text that this tab has seen last: where another tab has written since,
 * that tab's text is kept among the old ones; and so is one that has passed.
 */
export function saveText(id, text, base) {
  return change(id, (record) => {
    if ((record.text !== base || record.text === record.right) && record.text !== text) keepOld(record, record.text);
    record.text = text;
  });
}

/** Puts another text in the place of the present one, which is kept. */
export function replaceText(id, text) {
  return change(id, (record) => {
    if (record.text !== text) keepOld(record, record.text);
    record.text = text;
  });
}

export function saveHints(id, hints) {
  return change(id, (record) => (record.hints = Math.max(record.hints, hints)));
}

/** Tries are the different texts until one has passed; what is untouched is none. */
export function saveVerdict(id, text, verdict) {
  return change(id, (record) => {
    const started = !verdict.explanation.startsWith("·");
    if (verdict.judge_failure) return;
    record.tries += started && !record.passed && text !== record.checked ? 1 : 0;
    record.checked = text;
    record.last = verdict;
    record.passed ||= verdict.passed;
    if (verdict.passed) record.right = text;
  });
}

export function setting(name) {
  return transact("settings", "readonly", (table) => table.get(name));
}

export function saveSetting(name, value) {
  return transact("settings", "readwrite", (table) => table.put(value, name));
}

/** Calls `seen(id)` when another tab has changed the work on a unit, and `seen()` on coming back. */
export function onWorkOfOthers(seen) {
  channel?.addEventListener("message", ({ data }) => seen(data.id));
  addEventListener("focus", () => seen());
}
