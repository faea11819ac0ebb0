#include <doctest/doctest.h>

#include "project/browser/site.hpp"

using namespace tumble::test;

namespace {

/// Elements that reach beyond the window, and are not in a frame that scrolls: [name, how far].
const char* const overflows = R"js((() => {
  const wide = document.documentElement.clientWidth;
  const scrolls = (e) => {
    for (let p = e; p && p !== document.body; p = p.parentElement)
      if (["auto", "scroll", "hidden", "clip"].includes(getComputedStyle(p).overflowX)) return true;
    return false;
  };
  return [...document.querySelectorAll("#text *")]
    .filter((e) => e.getBoundingClientRect().right > wide + 1 && e.getClientRects().length > 0 && !scrolls(e))
    .slice(0, 5)
    .map((e) => e.tagName + "." + e.className + ": " + (e.textContent || "").slice(0, 60));
})())js";

}  // namespace

TEST_CASE("the site: no page complains, asks the network, or reaches beyond the window") {
  if (!can_look()) return;
  Chromium browser;
  const auto pages = pages_of_the_book();
  REQUIRE(pages.size() > 20);
  for (const auto& [width, phone] : {std::pair{1280, false}, {390, true}}) {
    browser.resize(width, 800, phone);
    for (const std::string& page : pages) {
      CAPTURE(page);
      CAPTURE(width);
      browser.open(address_of(page));
      CHECK(browser.evaluate(overflows) == nlohmann::json::array());
      CHECK(browser.evaluate("document.documentElement.scrollWidth") == width);
      CHECK(browser.complaints() == std::vector<std::string>{});
    }
  }
}
