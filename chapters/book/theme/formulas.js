// Sets the formulas. The text is hidden until then, so that it does not move under the reader's eyes.
renderMathInElement(document.getElementById("text"), {
  delimiters: [
    { left: "\\[", right: "\\]", display: true },
    { left: "\\(", right: "\\)", display: false },
  ],
  throwOnError: false,
});
document.documentElement.classList.remove("formulas-to-set");
document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();
