// A verdict as a page shows it: what ./tumble check says, with what it names one click away.
import { element } from "./element.mjs";

/** What the compiler says about lines of the student's file: [{line, column, kind, text}]. */
export function compilerMessages(verdict) {
  const name = verdict.unit.split("/").at(-1);
  const pattern = new RegExp(`^\\s*(?:\\S*/)?${name}\\.cpp:(\\d+):(\\d+): (?:fatal )?(error|warning): (.*)$`, "gm");
  return [...verdict.explanation.matchAll(pattern)].map(([, line, column, kind, text]) => ({
    line: +line, column: +column, kind, text,
  }));
}

const plain = (text) => text.trim().replaceAll(/\s+/g, " ");

/** The heading of a section on this page. */
function headingOf(section) {
  const headings = document.querySelectorAll("#text :is(h2, h3, h4)");
  const named = [...headings].find((heading) => plain(heading.firstChild.nextSibling?.textContent ?? "") === section ||
    plain(heading.textContent.replace(/#$/, "")) === section);
  return named?.querySelector("a.anchor[id]")?.id ?? named?.id;
}

/** The file that is judged is the text in the editor, except where a message names a line of it. */
function withoutFile(text, unit) {
  const file = `exercises/${unit}\\.cpp(?!:\\d)`;
  return text.replace(new RegExp(`^(\\s*)${file}`, "gm"), "$1Your text").replace(new RegExp(file, "g"), "your text");
}

/** Lines that name a command or a file of the course: what they are in a page. */
function rewritings(actions) {
  return [
    [/^(\s*)Read \S+, “(.*)”\.$/, (line, indent, section) => {
      const id = headingOf(section);
      return id ? [`${indent}Read `, element("a", { href: `#${id}` }, `“${section}”`), "."] : [line];
    }],
    [/^(\s*)To run only this case:\s+\.\/tumble check \S+ --seed (\d+)$/, (_, indent, seed) => [
      `${indent}These numbers come from seed ${seed}.  `,
      element("button", { type: "button", className: "in-text", onclick: () => actions.check(+seed) },
        "Check with the same numbers"),
    ]],
    [/^(\s*)Write it in .*$/, (_, indent) => [`${indent}Write it in the editor above.`]],
    [/^(\s*)A hint:\s+\.\/tumble hint \S+$/, (_, indent) => [
      indent, element("button", { type: "button", className: "in-text", onclick: actions.hint }, "A hint"),
    ]],
  ];
}

const styles = [
  [/^\s*✓/, "holds"], [/^\s*✗/, "fails"], [/^\s*It looks like “/, "misconception"], [/: error: /, "fails"],
];

function shownLine(line, rules) {
  const [pattern, make] = rules.find(([pattern]) => pattern.test(line)) ?? [/.*/, () => [line]];
  const className = styles.find(([pattern]) => pattern.test(line))?.[1] ?? "";
  const shown = element("span", { className }, ...make(...pattern.exec(line)), "\n");
  shown.style.setProperty("--indent", indentOf(line));
  return shown;
}

const indentOf = (line) => line.search(/\S|$/);

/** A line of sentences: no table, no number with a name, no code. */
const isProse = (line) => /^\s*[\p{L}“(]/u.test(line) && !/\S {2,}\S|[|=]/.test(line);

/** The terminal's lines, with sentences whole: a page breaks them where it ends itself. */
function reflowed(lines, rules) {
  const flows = (line) => isProse(line) && !rules.some(([pattern]) => pattern.test(line));
  const whole = [];
  lines.forEach((line, i) => {
    const above = lines[i - 1] ?? "";
    const goesOn = above.length > 60 && flows(above) && flows(line) && indentOf(above) === indentOf(line);
    if (goesOn) whole[whole.length - 1] += ` ${line.trim()}`;
    else whole.push(line);
  });
  return whole;
}

/** Its first line, and the others as the terminal has them. */
export function partsOf(verdict) {
  const [first, ...rest] = withoutFile(verdict.explanation, verdict.unit).trimEnd().split("\n");
  while (rest[0]?.trim() === "") rest.shift();
  return { first, rest };
}

/**
 * Puts a verdict up.
 * @param line, text the elements for its first line and for the others
 * @param actions {check(seed), hint()}
 */
export function showVerdict(verdict, { line, text }, actions) {
  const { first, rest } = partsOf(verdict);
  const rules = rewritings(actions);
  line.textContent = first;
  line.className = `verdict-line ${verdict.passed ? "holds" : first.startsWith("·") ? "" : "fails"}`;
  text.replaceChildren(...reflowed(rest, rules).map((each) => shownLine(each, rules)));
  text.hidden = rest.length === 0;
}
