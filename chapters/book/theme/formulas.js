// Sets the formulas. The text is hidden until they and their fonts are there, so that it does not move
// under the reader's eyes; but not for longer than a second.
const inText = /\\\(([^]*?)\\\)|\\\[([^]*?)\\\]/g;

function setFormulasOf(node) {
  const pieces = document.createDocumentFragment();
  let end = 0;
  for (const match of node.data.matchAll(inText)) {
    const displayMode = match[2] !== undefined;
    const formula = document.createElement("span");
    katex.render(displayMode ? match[2] : match[1], formula, { displayMode, throwOnError: false, macros: { "\\arraystretch": "1.15" } });
    pieces.append(node.data.slice(end, match.index), formula);
    end = match.index + match[0].length;
  }
  if (end > 0) node.replaceWith(pieces, node.data.slice(end));
}

const walker = document.createTreeWalker(document.getElementById("text"), NodeFilter.SHOW_TEXT);
const nodes = [];
while (walker.nextNode())
  if (!walker.currentNode.parentElement.closest("code, pre, .fragment, svg, script")) nodes.push(walker.currentNode);
nodes.forEach(setFormulasOf);

Promise.race([document.fonts.ready, new Promise((done) => setTimeout(done, 1000))]).then(() => {
  document.documentElement.classList.remove("formulas-to-set");
  openDetails(); // and go to where the address leads
});
