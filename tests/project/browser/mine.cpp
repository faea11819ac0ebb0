/// @file
/// A figure that asks the reader's own functions, without the compiler: what is asked, and what is
/// drawn of the answer.
#include "project/browser/exercise_page.hpp"

using namespace tumble::test;
using Json = nlohmann::json;

namespace {

/// The page of chapter 9 with its handle, the question about the download answered.
void open_handle(ExercisePage& page) {
  REQUIRE(page.says("check('passed')") == true);
  page.open_at("chapters-09_rigid_body.html#figure=handle&t=3");
  REQUIRE(page.says("until(() => document.querySelector('.moving-panel input[type=checkbox]'))") ==
          true);
  page.says(
      "globalThis.panel = document.querySelector('.moving-panel'), "
      "globalThis.mine = panel.querySelector('input[type=checkbox]'), "
      "globalThis.words = () => panel.querySelector('.mine p').textContent, "
      "globalThis.picture = () => "
      "document.querySelector('[data-figure$=\"handle.svg\"]').innerHTML, "
      "globalThis.own = picture()");
}

}  // namespace

TEST_CASE("a figure asks the reader's functions, and shows what they answer") {
  if (!can_try()) return;
  ExercisePage page;
  open_handle(page);
  page.says("mine.click()");
  REQUIRE(page.says("until(() => words().startsWith('Yours: 4.1.'))") == true);
  CHECK(page.says("asked.topic") == "motion");
  CHECK(page.says("asked.digits") == "09");
  CHECK(page.says("asked.count") == 32);
  CHECK(page.says("asked.files") ==
        Json{{{"id", "04_quaternions/product"}, {"text", "passed\nline two\n"}}});
  CHECK(page.says("picture() !== own") == true);
  page.says("mine.click()");
  CHECK(page.says("words()") == "");
  CHECK(page.says("picture() === own") == true);
}

TEST_CASE("a link on its own page leads to a figure that was not seen yet, with its settings") {
  if (!can_try()) return;
  ExercisePage page;
  page.open_at("chapters-09_rigid_body.html");
  page.says("location.hash = '#figure=handle&t=3'");
  REQUIRE(page.says("until(() => document.querySelector('.moving-panel output'))") == true);
  CHECK(page.says("document.querySelector('.moving-panel output').value") == "3.00 s");
}

TEST_CASE("a figure asks again when its question changes, and not when time goes on") {
  if (!can_try()) return;
  ExercisePage page;
  open_handle(page);
  page.says("mine.click()");
  REQUIRE(page.says("until(() => words().startsWith('Yours'))") == true);
  page.says(
      "globalThis.slide = (k, value) => { const range = "
      "panel.querySelectorAll('input[type=range]')[k]; "
      "range.value = value; range.dispatchEvent(new Event('input')); }, asked = null, slide(0, 5)");
  CHECK(page.says("asked === null && words().startsWith('Yours')") == true);
  page.says("slide(1, 2.5), mine.click()");  // the box is cleared before the functions are asked
  CHECK(page.says("new Promise((done) => setTimeout(() => done(asked === null && words() === ''), "
                  "500))") == true);
  page.says("mine.click()");
  REQUIRE(page.says("until(() => words().startsWith('Yours'))") == true);
  page.says("asked = null, slide(1, 3)");
  CHECK(page.says("words()") == "Asking your functions …");
  CHECK(page.says("until(() => asked && words().startsWith('Yours'))") == true);
}

TEST_CASE("a figure says why the functions did not answer, and shows its own motion") {
  if (!can_try()) return;
  ExercisePage page;
  open_handle(page);
  page.says("globalThis.refuses = true, mine.click()");
  CHECK(page.says("until(() => words() === 'Your functions give no answer: hung, a call has not "
                  "come back in 2 s.')") == true);
  CHECK(page.says("picture() === own") == true);
}
