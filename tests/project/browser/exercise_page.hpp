#pragma once
/// @file
/// The page of chapter 4 in a browser, with an editor in the box of 4.1 and a judge that pretends.

#include <doctest/doctest.h>

#include "project/browser/served_site.hpp"

namespace tumble::test {

/// A judge that looks at the text, which says what its verdict is.
inline const char* const stand_in_judge = R"js(
const said = {
  passed: "✓ 4.1 product  passed, all 5 laws hold  (0.01 s)\n",
  wrong: "✗ 4.1 product  wrong, 4 of 5 laws hold  (0.01 s)\n\n  ✗ a law\n\n" +
    "      It looks like “operands swapped”.\n      This is b a.\n" +
    "      Read chapters/04_quaternions/README.md, “The product”.\n\n" +
    "      To run only this case:  ./tumble check 4.1.1 --seed 7\n\n  ✓ another law\n",
  compile: "✗ 4.1 product  does not compile  (0.01 s)\n\n  The compiler does not accept exercises/04_quaternions/product.cpp:\n\n" +
    "    product.cpp:2:8: error: what is wrong\n",
};
export class Judge {
  async check(unit, source, { seed, onProgress, onHung, signal }) {
    onProgress({ done: 1, total: 2 });
    if (source.includes("endless")) onHung(2);
    if (source.includes("endless")) await new Promise((_, reject) => signal.addEventListener("abort", () => reject(signal.reason)));
    const how = Object.keys(said).find((word) => source.includes(word)) ?? "wrong";
    globalThis.seeds = [...(globalThis.seeds ?? []), seed];
    return { unit, number: "4.1", passed: how === "passed", summary: how, seed, laws: 5, laws_that_hold: 4,
      explanation: said[how], judge_failure: "", cases: [] };
  }
  async buildAhead(unit, source) {
    globalThis.ahead = [...(globalThis.ahead ?? []), source];
  }
  /** A body that stays as it is. */
  async answerFigure(digits, topic, numbers, files) {
    globalThis.asked = { digits, topic, count: numbers.length, files };
    if (globalThis.refuses) return { outcome: "hung", detail: "a call has not come back in 2 s" };
    return { numbers: Array.from({ length: 1001 }, () => numbers.slice(16, 29)).flat(), own: files.map(({ id }) => id) };
  }
}
)js";

inline const char* const page_helpers = R"js(
globalThis.box = document.getElementById("now-write-4.1");
globalThis.until = async (there) => {
  for (let i = 0; i < 400; ++i) {
    if (await there()) return true;
    await new Promise((resolve) => setTimeout(resolve, 25));
  }
  return false;
};
globalThis.button = (name) => [...box.querySelectorAll("button")].find((b) => b.textContent === name && !b.hidden);
globalThis.editor = () => box.querySelector(".CodeMirror")?.CodeMirror;
globalThis.write = (text) => editor().replaceRange(text, { line: 0, ch: 0 }, { line: 1e4, ch: 0 });
globalThis.line = () => box.querySelector(".verdict-line").textContent;
globalThis.check = async (how) => {
  write(how + "\nline two\n");
  box.querySelector(".verdict-line").textContent = "";
  button("Check").click();
  await until(() => /4.1 product/.test(line()) || button("Download and check"));
  button("Download and check")?.click();
  return until(() => /4.1 product/.test(line()) && button("Check").getAttribute("aria-disabled") === "false");
};
)js";

/// What all tests of a program read; what a page keeps is its browser's.
inline const ServedSite& site_of_stand_in() {
  static const ServedSite site{stand_in_judge};
  return site;
}

/// A browser on the page of chapter 4, the editor of 4.1 in it.
class ExercisePage {
 public:
  ExercisePage() {
    browser.resize(1280, 900);
    open();
  }

  void open() {
    open_at("chapters-04_quaternions.html#now-write-4.1");
    REQUIRE(says("until(() => editor())") == true);
  }
  void open_at(const std::string& address) {
    browser.open(site.address(address));
    browser.evaluate(page_helpers);
  }

  nlohmann::json says(const std::string& expression) { return browser.evaluate(expression); }

  const ServedSite& site = site_of_stand_in();
  Chromium browser;
};

inline bool can_try() {
  if (!std::filesystem::exists(ServedSite::editor()))
    return skip("the exercises in the page are not built: ./tumble book --exercises"), false;
  if (server_program().empty()) return skip("cpp-httplib is not here"), false;
  return can_look();
}

}  // namespace tumble::test
