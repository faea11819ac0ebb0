/// @file
/// The exercises in the page, without the compiler: the editor, the keys, what is kept and shown.
#include <doctest/doctest.h>

#include "project/browser/served_site.hpp"

using namespace tumble::test;
using Json = nlohmann::json;

namespace {

/// A judge that looks at the text: what its verdict is, stands in the text itself.
const char* const stand_in = R"js(
const said = {
  passed: "✓ 4.1 product  passed, all 5 laws hold  (0.01 s)\n",
  wrong: "✗ 4.1 product  wrong, 4 of 5 laws hold  (0.01 s)\n\n  ✗ a law\n\n" +
    "      It looks like “operands swapped”.\n      This is b a.\n" +
    "      Read chapters/04_quaternions/README.md, “The product”.\n\n" +
    "      To run only this case:  ./tumble check 4.1.1 --seed 7\n\n  ✓ another law\n",
  compile: "✗ 4.1 product  does not compile  (0.01 s)\n\n  The compiler does not accept product.cpp:\n\n" +
    "    product.cpp:2:8: error: what is wrong\n",
};
export class Judge {
  async check(unit, source, { seed, onProgress }) {
    onProgress({ done: 1, total: 2, what: "the compiler" });
    const how = Object.keys(said).find((word) => source.includes(word)) ?? "wrong";
    globalThis.seeds = [...(globalThis.seeds ?? []), seed];
    return { unit, number: "4.1", passed: how === "passed", summary: how, seed, laws: 5, laws_that_hold: 4,
      explanation: said[how], judge_failure: "", cases: [] };
  }
}
)js";

const char* const helpers = R"js(
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

/// A browser on the page of chapter 4, the editor of 4.1 in it.
class Page {
 public:
  Page() {
    browser.resize(1280, 900);
    open();
  }

  void open() {
    browser.open(site.address("chapters-04_quaternions.html#now-write-4.1"));
    browser.evaluate(helpers);
    REQUIRE(says("until(() => editor())") == true);
  }

  Json says(const std::string& expression) { return browser.evaluate(expression); }

  ServedSite site{stand_in};
  Chromium browser;
};

bool can_try() {
  const char* folder = std::getenv("TUMBLE_CODEMIRROR");
  if (!folder || !std::filesystem::exists(std::string(folder) + "/lib/codemirror.js"))
    return skip("CodeMirror is not here"), false;
  return can_look();
}

}  // namespace

TEST_CASE("exercises in the page: the box has the stub in an editor, and the command folded away") {
  if (!can_try()) return;
  Page page;
  CHECK(page.says("editor().getValue()").get<std::string>().find("throw NotImplemented{};") !=
        std::string::npos);
  CHECK(page.says("box.querySelector('.on-the-command-line').open") == false);
  CHECK(page.says("box.querySelector('.on-the-command-line .line').textContent") ==
        "./tumble check 4.1");
  CHECK(
      page.says(
          "until(() => box.querySelector('.demanded').textContent.includes('any quaternions'))") ==
      true);
  CHECK(page.says("document.documentElement.scrollWidth") == 1280);
}

TEST_CASE("exercises in the page: Tab indents, and after Escape it leaves") {
  if (!can_try()) return;
  Page page;
  page.says("editor().focus(), editor().setCursor(7, 0)");
  page.browser.press("Tab", 9);
  CHECK(page.says("editor().getLine(7)") == "    throw NotImplemented{};");
  page.browser.press("Escape", 27);
  page.browser.press("Tab", 9);
  CHECK(page.says("document.activeElement.textContent") == "Check");
  CHECK(page.says("editor().getLine(7)") == "    throw NotImplemented{};");
}

TEST_CASE("exercises in the page: the first check says what is downloaded, and asks once") {
  if (!can_try()) return;
  Page page;
  page.says("write('wrong'), button('Check').click()");
  REQUIRE(page.says("until(() => button('Download and check'))") == true);
  CHECK(page.says("box.querySelector('.download').textContent.includes('33.1 MB, once')") == true);
  page.says("button('Not now').click()");
  CHECK(page.says("until(() => !button('Not now'))") == true);
  CHECK(page.says("line()") == "");
  REQUIRE(page.says("check('wrong')") == true);
  page.open();
  page.says("button('Check').click()");
  CHECK(page.says("until(() => globalThis.seeds)") == true);
}

TEST_CASE("exercises in the page: a verdict links its section, and repeats its numbers") {
  if (!can_try()) return;
  Page page;
  REQUIRE(page.says("check('wrong')") == true);
  CHECK(page.says("line()") == "✗ 4.1 product  wrong, 4 of 5 laws hold  (0.01 s)");
  CHECK(page.says("box.querySelector('.verdict a').hash") ==
        "#chapters-04_quaternions-the-product");
  CHECK(
      page.says("[...box.querySelectorAll('.verdict .fails')].map((l) => l.textContent.trim())") ==
      Json{"✗ a law"});
  page.says("button('Check with the same numbers').click()");
  CHECK(page.says("until(() => seeds.at(-1) === 7 && seeds.length === 2)") == true);
  CHECK(page.says("button('Solution')") == Json());
}

TEST_CASE("exercises in the page: what the compiler says stands in its line") {
  if (!can_try()) return;
  Page page;
  REQUIRE(page.says("check('compile')") == true);
  CHECK(page.says("box.querySelector('.compiler-note').textContent") == "error: what is wrong");
  CHECK(page.says("editor().lineInfo(1).bgClass") == "compiler-line-error");
  REQUIRE(page.says("check('wrong')") == true);
  CHECK(page.says("box.querySelector('.compiler-note')") == Json());
}

TEST_CASE("exercises in the page: Reset keeps the text, and it can be put back") {
  if (!can_try()) return;
  Page page;
  page.says("write('mine\\n'), button('Reset').click()");
  CHECK(page.says("until(() => editor().getValue().includes('NotImplemented'))") == true);
  CHECK(page.says("until(() => button('Put back'))") == true);
  page.says("button('Put back').click()");
  CHECK(page.says("until(() => editor().getValue() === 'mine\\n')") == true);
}

TEST_CASE(
    "exercises in the page: text, verdict and hints are there when the page is opened again") {
  if (!can_try()) return;
  Page page;
  REQUIRE(page.says("check('passed')") == true);
  page.says("button('Hint').click(), button('Hint').click()");
  CHECK(page.says("until(async () => (await (await import('./exercises/store.mjs'))"
                  ".workOn('04_quaternions/product')).hints === 2)") == true);
  page.open();
  CHECK(page.says("editor().getValue()") == "passed\nline two\n");
  CHECK(page.says("line()") == "✓ 4.1 product  passed, all 5 laws hold  (0.01 s)");
  CHECK(page.says("box.querySelectorAll('.hints li').length") == 2);
  CHECK(page.says("button('Solution').textContent") == "Solution");
}

TEST_CASE("exercises in the page: a text that another tab has written is kept") {
  if (!can_try()) return;
  Page page;
  page.says(
      "write('first\\n'), until(async () => (await (await import('./exercises/store.mjs'))"
      ".workOn('04_quaternions/product')).text === 'first\\n')");
  const Json work = page.says(
      "import('./exercises/store.mjs').then(async (store) => { await store.saveText("
      "'04_quaternions/product', 'second', 'stale'); return "
      "store.workOn('04_quaternions/product'); })");
  CHECK(work["text"] == "second");
  CHECK(work["old"][0]["text"] == "first\n");
}

TEST_CASE("exercises in the page: the front page has a mark for each, and the count") {
  if (!can_try()) return;
  Page page;
  REQUIRE(page.says("check('passed')") == true);
  REQUIRE(page.says("until(async () => (await (await import('./exercises/store.mjs'))"
                    ".workOn('04_quaternions/product')).last)") == true);
  page.browser.open(page.site.address("index.html"));
  page.says(std::string(helpers) +
            "; until(() => document.querySelector('.exercise-progress .count'))");
  CHECK(page.says("document.querySelector('.exercise-progress .count').textContent") ==
        "1 of 2 exercises pass");
  CHECK(page.says("[...document.querySelectorAll('.exercise-progress .marks a')]"
                  ".map((a) => a.textContent)") == Json{"4.1✓", "4.2·"});
  CHECK(page.says("document.querySelector('.exercise-progress .marks a').href") ==
        page.site.address("chapters-04_quaternions.html#now-write-4.1"));
}

TEST_CASE(
    "exercises in the page: the work goes into a zip and comes back, and other zips are refused") {
  if (!can_try()) return;
  Page page;
  page.says(
      "write('häß → 1\\n'), until(async () => (await (await import('./exercises/store.mjs'))"
      ".workOn('04_quaternions/product')).text === 'häß → 1\\n')");
  page.says("import('./exercises/work.mjs').then((work) => globalThis.work = work)");
  CHECK(page.says("work.workAsZip().then((zip) => zip.arrayBuffer()).then(work.workIn)") ==
        Json{{{"id", "04_quaternions/product"}, {"text", "häß → 1\n"}, {"replaces", false}}});
  // As zip(1) packs it.
  page.says(
      "globalThis.packed = Uint8Array.from(atob('"
      "UEsDBBQAAgAIAHJnd10wxz/IEAAAADAAAAAiABwAaGFuZF9pbi8wNF9xdWF0ZXJuaW9ucy9wcm9kdWN0LmNwcFVU"
      "CQADuDgEa7g4BGt1eAsAAQQAAAAABAAAAADT11dISU3LSSxJTSGGwQUAUEsBAh4DFAACAAgAcmd3XTDHP8gQAAAA"
      "MAAAACIAGAAAAAAAAQAAAKSBAAAAAGhhbmRfaW4vMDRfcXVhdGVybmlvbnMvcHJvZHVjdC5jcHBVVAUAA7g4BGt1"
      "eAsAAQQAAAAABAAAAABQSwUGAAAAAAEAAQBoAAAAbAAAAAAA"
      "'), (c) => c.charCodeAt(0))");
  CHECK(page.says("work.workIn(packed.buffer)") ==
        Json{{{"id", "04_quaternions/product"},
              {"text", "// deflated deflated deflated deflated deflated\n"},
              {"replaces", true}}});
  CHECK(page.says("packed[100] ^= 1, work.workIn(packed.buffer).catch((error) => "
                  "/damaged/.test(error.message))") == true);
  CHECK(page.says("work.workIn(new Uint8Array(100).buffer).catch((error) => error.message)") ==
        "it is not a zip file");
}
