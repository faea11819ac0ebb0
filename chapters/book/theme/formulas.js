// Sets the formulas. The text is hidden until they and their fonts are there, so that it does not move
// under the reader's eyes; but not for longer than a second.
renderMathInElement(document.getElementById("text"), {
  delimiters: [
    { left: "\\[", right: "\\]", display: true },
    { left: "\\(", right: "\\)", display: false },
  ],
  throwOnError: false,
});
Promise.race([document.fonts.ready, new Promise((done) => setTimeout(done, 1000))]).then(() => {
  document.documentElement.classList.remove("formulas-to-set");
  openDetails(); // and go to where the address leads
});
