#include <doctest/doctest.h>

#include <map>

#include "project/browser/site.hpp"
#include "project/harness/command.hpp"
#include "project/harness/served_folder.hpp"

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

/// What a page has loaded, below the site: but for what comes when a reader scrolls to it, which
/// are the modules of figures and the editors.
const char* const loaded = R"js(
  ["resource", "navigation"].flatMap((kind) => performance.getEntriesByType(kind))
    .map((entry) => new URL(entry.name).pathname.slice(1))
    .filter((path) => !/^(moving\/[^/]*\.[^/]*\.js$|exercises\/)/.test(path)))js";

/// What a server sends of a file [bytes]: fonts are packed already.
long over_the_wire(const std::filesystem::path& file) {
  const bool font = file.extension() == ".woff2";
  const std::string show = font ? "cat '" : "gzip -c '";
  return std::stol(run_command(show + file.string() + "' | wc -c").output);
}

/// No complaint, no request of the network, nothing beyond the window.
void check_the_look(Chromium& browser, int width) {
  CHECK(browser.evaluate(overflows) == nlohmann::json::array());
  CHECK(browser.evaluate("document.documentElement.scrollWidth") == width);
  CHECK(browser.complaints() == std::vector<std::string>{});
}

}  // namespace

TEST_CASE(
    "the site: from a server, and on a desktop, a page asks for nothing else and is loaded soon") {
  if (!can_look()) return;
  if (server_program().empty()) return skip("the server is not built");
  constexpr long most = 260'000;  // two seconds at 1 Mbit/s; chapter 6 has 252 kB
  std::map<std::string, long> sizes;
  const ServedFolder server(site_folder());
  Chromium browser;
  browser.resize(1280, 800);
  for (const std::string& page : pages_of_the_book()) {
    CAPTURE(page);
    browser.open(server.address() + page);
    check_the_look(browser, 1280);
    long bytes = 0;
    for (const auto& path : browser.evaluate(loaded)) {
      const std::filesystem::path file = site_folder() / path.get<std::string>();
      REQUIRE(std::filesystem::exists(file));
      if (!sizes.contains(path)) sizes[path] = over_the_wire(file);
      bytes += sizes[path];
    }
    CHECK(bytes < most);
  }
}

TEST_CASE("the site: from disk, and on a phone, no page complains or reaches beyond the window") {
  if (!can_look()) return;
  Chromium browser;
  const auto pages = pages_of_the_book();
  REQUIRE(pages.size() > 20);
  browser.resize(390, 800, true);
  for (const std::string& page : pages) {
    CAPTURE(page);
    browser.open(address_of(page));
    check_the_look(browser, 390);
  }
}

TEST_CASE("the site: a box says that its figure moves, not where you find one that does") {
  if (!can_look()) return;
  Chromium browser;
  const char* const boxes =
      "[...document.querySelectorAll('.try-it')].map((box) => box.textContent).join()";
  for (const std::string page :
       {"chapters-04_quaternions.html", "chapters-11_when_bodies_meet.html"}) {
    browser.open(address_of(page));
    const std::string words = browser.evaluate(boxes);
    CHECK_MESSAGE(words.find("This figure moves") != std::string::npos, page);
    CHECK_MESSAGE(words.find("On the site that") == std::string::npos, page);
  }
}

TEST_CASE("the site: on a small screen Escape closes the menu") {
  if (!can_look()) return;
  Chromium browser;
  browser.resize(820, 1180, true);
  browser.open(address_of("chapters-04_quaternions.html"));
  const auto shown = [&] {
    return browser.evaluate("getComputedStyle(document.getElementById('sidebar')).display");
  };
  CHECK(shown() == "none");
  browser.evaluate("document.getElementById('to-menu').click()");
  CHECK(shown() == "block");
  browser.press("Escape", 27);
  CHECK(shown() == "none");
  CHECK(browser.evaluate("document.activeElement.id") == "to-menu");
}
