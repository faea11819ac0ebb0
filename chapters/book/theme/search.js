// Searches headings, terms, text and names, without a server: the index is a script beside the pages,
// and is loaded when the reader first goes into the box.
const query = document.getElementById("query");
const found = document.getElementById("found");
const foundCount = document.getElementById("found-count");
const most = 20;
let index, selected = -1, loading = false;

function loadIndex() {
  if (loading) return;
  loading = true;
  const script = document.createElement("script");
  script.src = "search_index.js";
  script.onload = () => {
    index = tumbleIndex.map(([address, page, section, terms, text]) => ({
      address, page, section, text,
      head: plain(section || page), page_: plain(page), terms_: plain(terms), text_: plain(text),
    }));
    search();
  };
  document.head.append(script);
}

// Lower case, and without accents; every character stays one, so that places stay the same.
function plain(text) {
  return [...text].map((c) => c.toLowerCase().normalize("NFD")[0]).join("");
}

// Where a word begins in a text with these letters; -1 if none does.
function place(text, letters) {
  for (let at = text.indexOf(letters); at >= 0; at = text.indexOf(letters, at + 1))
    if (at === 0 || !/[\p{L}\p{N}]/u.test(text[at - 1])) return at;
  return -1;
}

// How well a section fits; 0 if one of the words is not in it.
function score(entry, words) {
  let sum = 0;
  for (const word of words) {
    const points = (place(entry.head, word) >= 0 ? 20 : 0) + (place(entry.terms_, word) >= 0 ? 30 : 0) +
      (place(entry.text_, word) >= 0 ? 3 : 0) + (place(entry.page_, word) >= 0 ? 2 : 0);
    if (points === 0) return 0;
    sum += points + Math.min(entry.text_.split(word).length - 1, 5);
  }
  const chapter = /^chapters-\d/.test(entry.address) ? 10 : 0; // before exercises and names
  return sum + (entry.head === words.join(" ") ? 40 : 0) + chapter;
}

// The words of the text around the first word that was looked for, which is marked.
function excerpt(entry, words) {
  const line = document.createElement("span");
  line.className = "line-of-text";
  const [at, word] = words.map((w) => [place(entry.text_, w), w]).find(([p]) => p >= 0) ?? [-1, ""];
  if (at < 0) {
    line.textContent = entry.text.slice(0, 110);
    return line;
  }
  const characters = [...entry.text];
  const slice = (from, to) => characters.slice(Math.max(from, 0), to).join("");
  const marked = document.createElement("mark");
  marked.textContent = slice(at, at + word.length);
  line.append((at > 45 ? "…" : "") + slice(at - 45, at), marked, slice(at + word.length, at + 85) + "…");
  return line;
}

function item(entry, words, number) {
  const link = document.createElement("a");
  link.href = entry.address;
  const title = document.createElement("strong");
  title.textContent = entry.section || entry.page;
  const page = document.createElement("span");
  page.className = "page";
  page.textContent = entry.section ? entry.page : "";
  link.append(title, " ", page, excerpt(entry, words));
  link.addEventListener("click", close);
  const line = document.createElement("li");
  line.id = "found-" + number;
  line.append(link);
  return line;
}

function search() {
  const words = plain(query.value).split(/\s+/).filter((word) => word);
  select(-1);
  found.replaceChildren();
  found.hidden = words.length === 0;
  foundCount.textContent = "";
  if (words.length === 0) return;
  if (!index) return loadIndex();
  const best = index.map((entry) => [score(entry, words), entry]).filter(([points]) => points > 0)
    .sort(([a], [b]) => b - a);
  found.append(...best.slice(0, most).map(([, entry], i) => item(entry, words, i)));
  foundCount.textContent = best.length === 0 ? "Nothing found" : best.length + " found";
}

function select(number) {
  found.children[selected]?.classList.remove("selected");
  selected = Math.min(Math.max(number, -1), found.children.length - 1);
  found.children[selected]?.classList.add("selected");
  found.children[selected]?.scrollIntoView({ block: "nearest" });
}

function close() {
  query.value = "";
  search();
}

query.addEventListener("focus", loadIndex);
query.addEventListener("input", search);
query.addEventListener("keydown", (event) => {
  if (event.key === "ArrowDown") select(selected + 1);
  else if (event.key === "ArrowUp") select(selected - 1);
  else if (event.key === "Enter") found.children[Math.max(selected, 0)]?.firstChild.click();
  else if (event.key === "Escape") close();
  else return;
  event.preventDefault();
});
addEventListener("keydown", (event) => {
  if (event.key !== "/" || event.target.closest("input, textarea, [contenteditable]")) return;
  event.preventDefault();
  query.focus();
});
document.addEventListener("click", (event) => {
  if (!event.target.closest("#finder")) found.hidden = true;
});
