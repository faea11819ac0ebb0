/// @file
/// The exercises in the page, without the compiler: the editor, its keys, a check and its verdict.
#include "project/browser/exercise_page.hpp"

using namespace tumble::test;
using Json = nlohmann::json;

TEST_CASE("exercises in the page: the box has the stub in an editor, and the command folded away") {
  if (!can_try()) return;
  ExercisePage page;
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

TEST_CASE("exercises in the page: a box has the contract's sentences, and its title once") {
  if (!can_try()) return;
  ExercisePage page;
  page.says(
      "import(new URL('exercises/task.mjs', location)).then(({ contractText }) => globalThis.words "
      "= contractText({ chapter: '01_particles', number: '1.1' }))");
  CHECK(page.says("until(() => words.textContent.includes('Leave the masses out'))") == true);
  CHECK(page.says("words.textContent.includes('Many particles, one state')") == false);
}

TEST_CASE("exercises in the page: Tab indents, and after Escape it leaves") {
  if (!can_try()) return;
  ExercisePage page;
  page.says("editor().focus(), editor().setCursor(7, 0)");
  page.browser.press("Tab", 9);
  CHECK(page.says("editor().getLine(7)") == "    throw NotImplemented{};");
  page.browser.press("Escape", 27);
  page.browser.press("Tab", 9);
  CHECK(page.says("document.activeElement.textContent") == "Check");
  CHECK(page.says("editor().getLine(7)") == "    throw NotImplemented{};");
  page.says("editor().focus()");  // Tab was the last key: a reader goes through the page by it
  page.browser.press("Tab", 9);
  CHECK(page.says("document.activeElement.textContent") == "Check");
  CHECK(page.says("editor().getLine(7)") == "    throw NotImplemented{};");
}

TEST_CASE("exercises in the page: the first check says what is downloaded, and asks once") {
  if (!can_try()) return;
  ExercisePage page;
  page.says("write('wrong'), button('Check').focus(), button('Check').click()");
  REQUIRE(page.says("until(() => button('Download and check'))") == true);
  CHECK(page.says("document.activeElement === button('Download and check')") == true);
  CHECK(page.says("box.querySelector('.download').textContent.includes('33.1 MB, once')") == true);
  page.says("button('Not now').click()");
  CHECK(page.says("until(() => !button('Not now'))") == true);
  CHECK(page.says("document.activeElement === button('Check')") == true);
  CHECK(page.says("line()") == "");
  REQUIRE(page.says("check('wrong')") == true);
  page.open();
  page.says("button('Check').click()");
  CHECK(page.says("until(() => globalThis.seeds)") == true);
}

TEST_CASE("exercises in the page: a verdict links its section, and repeats its numbers") {
  if (!can_try()) return;
  ExercisePage page;
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

TEST_CASE("exercises in the page: what the compiler says is shown in its line") {
  if (!can_try()) return;
  ExercisePage page;
  REQUIRE(page.says("check('compile')") == true);
  CHECK(page.says("box.querySelector('.compiler-note').textContent") == "error: what is wrong");
  CHECK(page.says("editor().lineInfo(1).bgClass") == "compiler-line-error");
  CHECK(page.says(
            "box.querySelector('.verdict').textContent.includes('does not accept your text:')") ==
        true);
  REQUIRE(page.says("check('wrong')") == true);
  CHECK(page.says("box.querySelector('.compiler-note')") == Json());
}

TEST_CASE("exercises in the page: what runs too long is stopped, and there is no verdict") {
  if (!can_try()) return;
  ExercisePage page;
  REQUIRE(page.says("check('wrong')") == true);
  page.says("write('endless'), button('Check').click()");
  REQUIRE(page.says("until(() => line().includes('2 calls have not come back'))") == true);
  page.says("button('Stop').click()");
  CHECK(page.says("until(() => line() === 'Stopped: there is no verdict.')") == true);
  CHECK(page.says("until(() => button('Check').getAttribute('aria-disabled') === 'false')") ==
        true);
  // What stands below is of the text before.
  CHECK(page.says("box.querySelector('.verdict').classList.contains('of-before')") == true);
  CHECK(page.says("check('passed')") == true);
  CHECK(page.says("box.querySelector('.verdict').classList.contains('of-before')") == false);
}

TEST_CASE("exercises in the page: who pauses finds their text built, once they have agreed") {
  if (!can_try()) return;
  ExercisePage page;
  page.says("editor().focus(), write('unasked')");
  page.says("new Promise((resolve) => setTimeout(resolve, 1500))");
  CHECK(page.says("globalThis.ahead") == Json());
  REQUIRE(page.says("check('wrong')") == true);
  page.says("write('thought over')");
  CHECK(page.says("until(() => globalThis.ahead?.at(-1) === 'thought over')") == true);
  page.open();
  page.says("editor().focus()");
  CHECK(page.says("until(() => globalThis.ahead?.at(-1) === 'thought over')") == true);
}

TEST_CASE("exercises in the page: you close a brace, the editor closes any other bracket") {
  if (!can_try()) return;
  ExercisePage page;
  page.says("write(''), editor().focus()");
  page.browser.type("f(x[1] {}");
  CHECK(page.says("editor().getValue()") == "f(x[1] {})");
}

TEST_CASE("exercises in the page: a text is built once, and only the last one ahead") {
  if (!can_try()) return;
  ExercisePage page;
  page.says(R"js((async () => {
    globalThis.asked = [];
    globalThis.Worker = class { // compiles and judges anything
      postMessage({ id, source, built }) {
        asked.push(`${built ? "judge" : "build"} ${source}`);
        setTimeout(() => this.onmessage({ data: { id, built: { ok: true }, ...(built && { verdict: "{}" }) } }), 20);
      }
    };
    const { Judge } = await import(new URL("exercises/true_client.mjs", location));
    const judge = new Judge(), check = (text) => judge.check("04_quaternions/product", text, { seed: 1 });
    await Promise.all(["a", "b", "c"].map((text) => judge.buildAhead("04_quaternions/product", text)));
    await check("c");
    await check("c");
    await check("d");
    globalThis.done = true;
  })())js");
  REQUIRE(page.says("until(() => globalThis.done)") == true);
  CHECK(page.says("asked") == Json{"build c", "judge c", "judge c", "build d", "judge d"});
}

TEST_CASE("exercises in the page: Stop ends the wait for a text that is built ahead") {
  if (!can_try()) return;
  ExercisePage page;
  page.says(R"js((async () => {
    globalThis.Worker = class { postMessage() {} }; // never answers
    const { Judge } = await import(new URL("exercises/true_client.mjs", location));
    const judge = new Judge(), stop = new AbortController();
    judge.buildAhead("04_quaternions/product", "slow");
    judge.check("04_quaternions/product", "other", { seed: 1, signal: stop.signal }).catch(({ name }) => (globalThis.ended = name));
    setTimeout(() => stop.abort(), 100);
  })())js");
  CHECK(page.says("until(() => globalThis.ended === 'AbortError')") == true);
}

TEST_CASE("exercises in the page: what has passed says where to go on") {
  if (!can_try()) return;
  ExercisePage page;
  REQUIRE(page.says("check('wrong')") == true);
  CHECK(page.says("box.querySelector('.next').hidden") == true);
  REQUIRE(page.says("check('passed')") == true);
  REQUIRE(page.says("until(() => !box.querySelector('.next').hidden)") == true);
  CHECK(page.says("box.querySelector('.next').textContent.startsWith('Next: 4.2 ')") == true);
  CHECK(page.says("box.querySelector('.next a').hash") == "#now-write-4.2");
  page.says("button('Reset').click()");
  CHECK(page.says("until(() => box.querySelector('.next').hidden)") == true);
}

TEST_CASE("exercises in the page: Reset keeps the text, and it can be put back") {
  if (!can_try()) return;
  ExercisePage page;
  page.says("write('mine\\n'), button('Reset').click()");
  CHECK(page.says("until(() => editor().getValue().includes('NotImplemented'))") == true);
  CHECK(page.says("until(() => button('Put this back'))") == true);
  page.says("button('Put this back').click()");
  CHECK(page.says("until(() => editor().getValue() === 'mine\\n')") == true);
}

TEST_CASE("exercises in the page: from disk, where no editor can be, the box says how to get one") {
  if (!can_try()) return;
  ExercisePage page;
  CHECK(page.says("document.querySelector('.where-to-write')") == Json());
  page.browser.open(page.site.from_disk("chapters-04_quaternions.html"));
  CHECK(page.says("document.getElementById('now-write-4.1').lastChild.textContent.includes('book "
                  "--serve')") == true);
}
