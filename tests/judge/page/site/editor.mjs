// An editor for C++: CodeMirror, fetched when the first one is needed.
import { base } from "./course.mjs";
import { element } from "./element.mjs";

let loaded = null;

function script(name) {
  return new Promise((resolve, reject) => {
    const made = element("script", { src: new URL(`codemirror/${name}`, base).href, onload: resolve });
    made.onerror = () => reject(new Error(`${name} cannot be read`));
    document.head.append(made);
  });
}

function loadCodeMirror() {
  loaded ??= (async () => {
    const href = new URL("codemirror/codemirror.css", base).href;
    document.head.prepend(element("link", { rel: "stylesheet", href }));
    await script("codemirror.js");
    await Promise.all(["clike.js", "matchbrackets.js", "closebrackets.js"].map(script));
  })();
  return loaded;
}

const pairs = '()[]""'; // no braces: if you type both, there would be one too many

let cameByTab = false; // whether the last thing that a reader did was to press Tab
document.addEventListener("keydown", ({ key }) => (cameByTab = key === "Tab"), true);
document.addEventListener("pointerdown", () => (cameByTab = false), true);

/** Tab indents; after Escape it leaves, as it does everywhere else, until something is typed. So it does for who came by it. */
function keys(check) {
  const indents = {
    Tab: (editor) => (editor.somethingSelected() ? editor.indentSelection("add") : editor.execCommand("insertSoftTab")),
    "Shift-Tab": "indentLess",
    "Ctrl-Enter": check,
    "Cmd-Enter": check,
  };
  const leave = (editor) => editor.setOption("extraKeys", { ...indents, Tab: false, "Shift-Tab": false });
  return { indents: { ...indents, Esc: leave }, leave };
}

function nameForReaders(editor, label, describedBy) {
  const field = editor.getInputField();
  field.setAttribute("aria-label", label);
  field.setAttribute("aria-describedby", describedBy);
}

function markLine(editor, { line, column, kind, text }) {
  const at = Math.min(line, editor.lineCount()) - 1;
  const note = element("div", { className: `compiler-note ${kind}` }, `${kind}: ${text}`);
  const marked = editor.getLineHandle(at); // a line's number changes when others come before it
  editor.addLineClass(marked, "background", `compiler-line-${kind}`);
  const widget = editor.addLineWidget(at, note, { coverGutter: false });
  const end = { line: at, ch: Math.max(column, editor.findWordAt({ line: at, ch: column - 1 }).head.ch) };
  const mark = editor.markText({ line: at, ch: column - 1 }, end, { className: `compiler-mark-${kind}` });
  return () => {
    editor.removeLineClass(marked, "background", `compiler-line-${kind}`);
    widget.clear();
    mark.clear();
  };
}

/**
 * @param place where it goes
 * @param options {text, label, describedBy, check, changed, focused}: what it holds; its name for a
 *   screen reader, and the id of its help; what Ctrl-Enter, a change and coming to it call
 */
export async function makeEditor(place, { text, label, describedBy, check, changed, focused }) {
  await loadCodeMirror();
  place.replaceChildren();
  const touch = matchMedia("(pointer: coarse)").matches;
  const { indents, leave } = keys(check);
  const editor = globalThis.CodeMirror(place, {
    value: text, mode: "text/x-c++src", theme: "tumble", indentUnit: 2, tabSize: 2, lineNumbers: true,
    lineWrapping: true, matchBrackets: true, autoCloseBrackets: !touch && pairs, viewportMargin: Infinity, extraKeys: indents,
    inputStyle: touch ? "contenteditable" : "textarea",
  });
  nameForReaders(editor, label, describedBy);
  const indentAgain = () => editor.setOption("extraKeys", indents);
  editor.on("focus", () => (cameByTab ? leave(editor) : indentAgain()));
  editor.on("focus", focused);
  let marks = [];
  const unmark = () => marks.splice(0).forEach((clear) => clear());
  editor.on("changes", (_, changes) => {
    indentAgain();
    if (changes.some(({ origin }) => origin !== "setValue")) changed();
  });
  return {
    text: () => editor.getValue(),
    replace(other) {
      unmark();
      editor.setValue(other);
    },
    focus: () => editor.focus(),
    hasFocus: () => editor.hasFocus(),
    /** Shows what the compiler says, each in its line: [{line, column, kind, text}]. */
    mark(messages) {
      unmark();
      marks = messages.map((message) => markLine(editor, message));
    },
  };
}
