/// @file
/// The exercises in the page with the real compiler and judge: after the first check nothing needs
/// the network.
#include "project/browser/exercise_page.hpp"

using namespace tumble::test;

namespace {

/// What the bars of a download name as the whole, "38.4 MB".
const char* const totals_of_bars = R"js(
globalThis.totals = new Set();
new MutationObserver(() => {
  for (const bar of document.querySelectorAll("progress"))
    for (const [, total] of bar.parentNode.textContent.matchAll(/ of (.+)/g)) totals.add(total);
}).observe(document.body, { subtree: true, childList: true, characterData: true });
)js";

/// Waits for what the page needs minutes for: it compiles the compiler, or fetches what is left.
bool comes(Chromium& browser, const std::string& condition) {
  for (int i = 0; i < 30; ++i)  // ten seconds each
    if (browser.evaluate("until(async () => " + condition + ")") == true) return true;
  return false;
}

/// Checks a text in the box of an exercise.
/// @return the line of its verdict, or what the page says instead
std::string verdict_line(Chromium& browser, const std::string& number, const std::string& text) {
  browser.evaluate(page_helpers);
  browser.evaluate("box = document.getElementById('now-write-" + number +
                   "'), box.scrollIntoView()");
  REQUIRE(browser.evaluate("until(() => editor())") == true);
  browser.evaluate("write(" + nlohmann::json(text).dump() + "), button('Check').click()");
  const std::string ended = "/^[✓✗]|not a verdict/.test(line())";
  comes(browser, "button('Download and check') || " + ended);
  browser.evaluate("button('Download and check')?.click()");
  comes(browser, ended);
  return browser.evaluate("line()");
}

std::string solution_of(const std::string& unit) {
  return tumble::support::read_text(std::string(std::getenv("TUMBLE_ROOT")) + "/solutions/" + unit +
                                    ".cpp");
}

}  // namespace

TEST_CASE("exercises in the page: after the first check, without a network") {
  if (!can_try()) return;
  ServedSite site;
  Chromium browser;
  const std::string page = site.address("chapters-04_quaternions.html"),
                    unread = site.address("chapters-05_momentum.html");
  browser.open(page);
  browser.evaluate(totals_of_bars);
  const std::string first = verdict_line(browser, "4.1", solution_of("04_quaternions/product"));
  CHECK_MESSAGE(first.starts_with("✓ 4.1 product"), first);
  // One bar for the compiler; one for the judge, unless that comes in one piece; none that grows
  // while it fills.
  const int totals = browser.evaluate("totals.size").get<int>();
  CHECK_MESSAGE((totals == 1 || totals == 2), browser.evaluate("[...totals].join()"));
  // The last that is kept.
  CHECK(comes(browser, "(await import('./exercises/store.mjs')).setting('small files')"));

  site.stop();
  browser.open(page);
  CHECK(browser.evaluate("fetch('there_is_no_network').then(() => true, () => false)") == false);
  const std::string second = verdict_line(browser, "4.2", solution_of("04_quaternions/inverse"));
  CHECK_MESSAGE(second.starts_with("✓ 4.2 inverse"), second);
  browser.open(unread);
  CHECK(browser.evaluate("document.querySelectorAll('.now-write').length").get<int>() > 0);
}
