// What a page does besides being read: the switch of colours, code to copy, links to sections, the
// section that is read now, and details that open where a link leads into them.
document.getElementById("mode").addEventListener("click", changeMode);
applyMode();

const text = document.getElementById("text");

for (const fragment of text.querySelectorAll("div.fragment")) {
  const button = document.createElement("button");
  button.className = "copy";
  button.textContent = "Copy";
  button.addEventListener("click", () => {
    const lines = [...fragment.querySelectorAll(".line")].map((line) => {
      const code = line.cloneNode(true);
      code.querySelectorAll(".lineno, .ttc").forEach((part) => part.remove());
      return code.textContent;
    });
    navigator.clipboard.writeText(lines.join("\n") + "\n").then(() => {
      button.textContent = "Copied";
      setTimeout(() => (button.textContent = "Copy"), 2000);
    });
  });
  fragment.append(button);
}

for (const anchor of text.querySelectorAll(":is(h1, h2, h3, h4) > a.anchor[id]")) {
  const link = document.createElement("a");
  link.className = "to-section";
  link.href = "#" + anchor.id;
  link.textContent = "#";
  link.setAttribute("aria-label", "Link to this section");
  anchor.parentElement.append(link);
}

// Who reads this is in the site already; on paper and in the repository the whole sentence stays.
for (const paragraph of text.querySelectorAll(".try-it p, figcaption"))
  paragraph.innerHTML = paragraph.innerHTML.replace(/On the site that <code>\.\/tumble book<\/code> opens, (.)/, (all, first) => first.toUpperCase());

// A short piece of code stays in its line: an option would break behind its first hyphen.
for (const code of text.querySelectorAll(":is(p, li) > code")) code.classList.toggle("short", code.textContent.length < 40);
for (const code of text.querySelectorAll(":is(p, li, td) > code")) code.classList.toggle("a-word", code.textContent.length < 16);
// In a longer one, what has a hyphen does, and a path goes on in the next line behind a slash.
for (const code of text.querySelectorAll(":is(p, li, td) > code:not(.a-word), :is(p, li, td) > a > code"))
  if (!code.firstElementChild)
    code.innerHTML = code.innerHTML.replace(/(?<=^| )(?=[^ ]{1,24}(?: |$))[^ ]*-[^ ]*/g, "<span class='a-word'>$&</span>").replace(/(\w\/)(?=\w)/g, "$1<wbr>");

// A table that is too wide by a few pixels gets narrower gaps, rather than a scroll bar for half a number.
for (const table of text.querySelectorAll(".scroll > table.numbers")) {
  const over = table.offsetWidth - table.parentElement.clientWidth;
  table.classList.toggle("close", over > 0 && over <= 2 * table.rows[0].cells.length);
}

const pageContents = document.querySelector(".page-contents");
if (pageContents) {
  // Beside the text it stays open; above the text it would push the text away.
  const beside = matchMedia("(min-width: 1240px)");
  const unfold = () => (pageContents.querySelector("details").open = beside.matches);
  beside.addEventListener("change", unfold);
  unfold();
  const links = new Map();
  for (const link of pageContents.querySelectorAll("a")) {
    const target = document.getElementById(decodeURIComponent(link.hash.slice(1)));
    if (target) links.set(target.closest("h1, h2, h3, h4") ?? target, link);
  }
  const mark = () => {
    let now;
    for (const heading of links.keys())
      if (heading.getBoundingClientRect().top < innerHeight / 3) now = heading;
    for (const [heading, link] of links)
      heading === now ? link.setAttribute("aria-current", "true") : link.removeAttribute("aria-current");
  };
  document.addEventListener("scroll", mark, { passive: true });
  mark();
}

function openDetails() {
  let place = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  const target = place;
  for (; place; place = place.parentElement) if (place.tagName === "DETAILS") place.open = true;
  target?.scrollIntoView();
}
addEventListener("hashchange", openDetails);

document.querySelector("#sidebar [aria-current]")?.scrollIntoView({ block: "center" });
scrollTo(scrollX, scrollY);

/** On a small screen the menu covers the page. */
function closeMenu({ key }) {
  if (key !== "Escape" || location.hash !== "#sidebar") return;
  document.getElementById("from-menu").click();
  document.getElementById("to-menu").focus();
}
addEventListener("keydown", closeMenu);

/** Browsers take the scripts of the exercises from a server only. */
function sayWhereToWrite() {
  if (location.protocol !== "file:" || !document.querySelector("script.editors")) return;
  for (const box of text.querySelectorAll(".now-write")) {
    const note = document.createElement("p");
    note.className = "where-to-write";
    note.innerHTML = "To write it here, in the page, open the site with <code class='short'>./tumble book --serve</code>: an editor takes a server.";
    box.append(note);
  }
}
addEventListener("DOMContentLoaded", sayWhereToWrite);
