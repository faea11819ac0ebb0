/// @file
/// What a reader has written in the pages: it is kept, shown on the front page, and goes into a
/// zip.
#include "project/browser/exercise_page.hpp"

using namespace tumble::test;
using Json = nlohmann::json;

TEST_CASE(
    "exercises in the page: text, verdict and hints are there when the page is opened again") {
  if (!can_try()) return;
  ExercisePage page;
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
  ExercisePage page;
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
  ExercisePage page;
  REQUIRE(page.says("check('passed')") == true);
  REQUIRE(page.says("until(async () => (await (await import('./exercises/store.mjs'))"
                    ".workOn('04_quaternions/product')).last)") == true);
  const std::string sidebar =
      "document.querySelector('#sidebar a[href$=\"#now-write-4.2\"]')?.textContent";  // the next
                                                                                      // one
  CHECK(page.says("until(() => " + sidebar + " === '1 of 2')") == true);
  page.open_at("index.html");
  CHECK(page.says("until(() => " + sidebar + " === '1 of 2')") == true);
  page.says("until(() => document.querySelector('.exercise-progress .count'))");
  CHECK(page.says("document.querySelector('.exercise-progress .count').textContent") ==
        "1 of 2 exercises have passed");
  CHECK(page.says("[...document.querySelectorAll('.exercise-progress .marks a')]"
                  ".map((a) => a.textContent)") == Json{"4.1✓", "4.2·"});
  CHECK(page.says("document.querySelector('.exercise-progress .marks a').href") ==
        page.site.address("chapters-04_quaternions.html#now-write-4.1"));
  CHECK(page.says("document.querySelector('#text p a[href=\"#your-exercises\"]').textContent") ==
        "You can write the exercises in these pages.");
  page.open();
  page.says(
      "write('other\\n'), until(async () => (await (await import('./exercises/store.mjs'))"
      ".workOn('04_quaternions/product')).text === 'other\\n')");
  page.open_at("index.html");
  page.says("until(() => document.querySelector('.exercise-progress .marks a'))");
  CHECK(page.says("document.querySelector('.exercise-progress .marks a').textContent") == "4.1✎");
}

TEST_CASE(
    "exercises in the page: the work goes into a zip and comes back, and other zips are refused") {
  if (!can_try()) return;
  ExercisePage page;
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

TEST_CASE("exercises in the page: what was reset after passing is not in the zip, which is said") {
  if (!can_try()) return;
  ExercisePage page;
  REQUIRE(page.says("check('passed')") == true);
  page.says("button('Reset').click()");
  CHECK(page.says("until(() => button('Put this back'))") == true);
  page.open_at("index.html");
  REQUIRE(page.says("until(() => document.querySelector('.exercise-progress button'))") == true);
  page.says("globalThis.box = document.querySelector('.exercise-progress')");
  page.says("button('Download my work').click()");
  CHECK(page.says("until(() => box.querySelector('[role=status]').textContent.startsWith("
                  "'Nothing to download. Not in it: 4.1, reset after passing.'))") == true);
}
