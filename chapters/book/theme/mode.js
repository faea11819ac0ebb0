// Light or dark: what the reader chose, else what the system says. It runs before anything is drawn.
const darkSystem = matchMedia("(prefers-color-scheme: dark)");

function chosenMode() {
  try {
    return localStorage.getItem("mode");
  } catch {
    return null; // a browser that keeps nothing
  }
}

function applyMode() {
  const dark = chosenMode() ? chosenMode() === "dark" : darkSystem.matches;
  document.documentElement.classList.toggle("dark-mode", dark);
  document.documentElement.classList.toggle("light-mode", !dark);
  const button = document.getElementById("mode");
  if (!button) return;
  button.hidden = false;
  button.textContent = dark ? "Light" : "Dark";
}

function changeMode() {
  const dark = document.documentElement.classList.contains("dark-mode");
  try {
    localStorage.setItem("mode", dark ? "light" : "dark");
  } catch {}
  applyMode();
}

document.documentElement.classList.add("formulas-to-set");
darkSystem.addEventListener("change", applyMode);
applyMode();
