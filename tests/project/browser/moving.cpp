#include <doctest/doctest.h>

#include <map>

#include "project/browser/site.hpp"
#include "project/harness/command.hpp"

using namespace tumble::test;
using Json = nlohmann::json;

namespace {

namespace fs = std::filesystem;

/// What a reader may have to download for a figure: its module, compressed [bytes].
constexpr std::uintmax_t most_bytes = 60 * 1024;

/// A figure that moves, and its page.
struct Moving {
  std::string picture, chapter, name, page;

  /// Whether it is the picture itself that moves; else it replaces that.
  bool is_its_own() const { return fs::path(picture).stem() == name; }
};

std::vector<Moving> figures_that_move() {
  const std::string index = tumble::support::read_text(site_folder() / "moving/index.js");
  const std::size_t begin = index.find('{'), end = index.rfind(',');
  if (end == std::string::npos || begin == std::string::npos) return {};
  std::vector<Moving> figures;
  const Json list = Json::parse(index.substr(begin, end - begin) + "}");
  for (const auto& [picture, where] : list.items())
    for (const std::string& page : pages_of_the_book())
      if (tumble::support::read_text(site_folder() / page).find("data-figure=\"" + picture) !=
          std::string::npos)
        figures.push_back({picture, where[0], where[1], page});
  return figures;
}

/// Waits for the figure, and leaves it in `figure`.
std::string find(const Moving& moving) {
  return R"js((async () => {
    const place = document.querySelector('[data-figure=")js" +
         moving.picture + R"js("]');
    place.scrollIntoView({ block: "center", behavior: "instant" });
    for (let i = 0; i < 200; ++i) {
      for (const each of await Promise.all(tumbleMoving.figures))
        if (each && each.place === place) { window.figure = each; each.play(false); return true; }
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    return false;
  })())js";
}

/// Sets each control to this part of its range, and gives what the program is told for it.
Json set_all(Chromium& browser, double part) {
  return browser.evaluate(
      "(() => { const s = figure.settings(); const said = []; figure.controls."
      "forEach((c, k) => { const n = Math.round((c.most - c.least) * " +
      std::to_string(part) +
      " / c.step); s[k] = c.least + n * c.step; said.push(c.name + '=' + s[k]); "
      "}); return said; })()");
}

/// A place of the picture [px of the window] that is the middle of its first grip, or on none.
std::string place_of(bool grip) {
  return std::string(
             "(() => { const svg = figure.place.querySelector('svg');"
             "const box = svg.getBoundingClientRect(), tries = [];"
             "const first = svg.querySelector('.grip').getBoundingClientRect();"
             "tries.push([first.x + first.width / 2, first.y + first.height / 2]);"
             "for (let i = 1; i < 20; ++i) for (let k = 1; k < 20; ++k)"
             "  tries.push([box.x + box.width * i / 20, box.y + box.height * k / 20]);"
             "return tries.find(([x, y]) => { const at = document.elementFromPoint(x, y);"
             "  return at && svg.contains(at) && !!at.closest('.grip') === ") +
         (grip ? "true" : "false") + "; }); })()";
}

/// What a press on the beginning, middle or end of a grip meets instead of the grip. There a figure
/// shows what can be dragged.
constexpr const char* what_covers_grips = R"js((() => {
  const met = [];
  for (const grip of figure.place.querySelectorAll(".grip"))
    for (const part of [0, 0.5, 1]) {
      const at = grip.getPointAtLength(part * grip.getTotalLength()).matrixTransform(grip.getScreenCTM());
      const element = document.elementFromPoint(at.x, at.y);
      if (!element?.closest(".grip")) met.push(element?.outerHTML.slice(0, 100) ?? "nothing");
    }
  return met;
})())js";

/// Empty if two pictures are the same; else what each has at the first place where they differ.
std::string difference(const std::string& page, const std::string& program) {
  if (page == program) return "";
  const auto at = std::mismatch(page.begin(), page.end(), program.begin(), program.end()).first;
  const auto i = static_cast<std::size_t>(at - page.begin()), from = i < 40 ? 0 : i - 40;
  return "page: …" + page.substr(from, 80) + "…\nprogram: …" + program.substr(from, 80) + "…";
}

std::string program_of(const Moving& moving) {
  return std::string(std::getenv("TUMBLE_CHAPTERS")) + "/" + moving.chapter;
}

}  // namespace

TEST_CASE("moving figures: the page draws what the program draws, byte for byte") {
  if (!can_look()) return;
  const auto figures = figures_that_move();
  if (figures.empty()) return skip("nothing was compiled for the browser");
  Chromium browser;
  browser.resize(1280, 900);
  for (const Moving& moving : figures) {
    CAPTURE(moving.picture);
    browser.open(address_of(moving.page));
    REQUIRE(browser.evaluate(find(moving)) == true);
    browser.evaluate("figure.reset()");
    const fs::path root = std::getenv("TUMBLE_ROOT");
    const auto drawn = [&] { return browser.evaluate("figure.module.draw()").get<std::string>(); };
    if (moving.is_its_own())
      CHECK(difference(drawn(), tumble::support::read_text(root / moving.picture)) == "");
    for (const double part : {0.3, 0.77}) {
      std::string command = program_of(moving) + " --figure " + moving.name;
      for (const Json& setting : set_all(browser, part))
        command += " --set " + setting.get<std::string>();
      const CommandResult native = run_command(command);
      REQUIRE(native.status == 0);
      CHECK(difference(drawn(), native.output) == "");
    }
    CHECK(browser.complaints() == std::vector<std::string>{});
  }
}

TEST_CASE("moving figures: what a reader downloads for one is small") {
  if (!can_look()) return;
  for (const Moving& moving : figures_that_move()) {
    const fs::path script = site_folder() / "moving" / (moving.chapter + "." + moving.name + ".js");
    CAPTURE(script.string());
    CHECK(fs::file_size(script) / 4 * 3 < most_bytes);  // base64
  }
}

TEST_CASE("moving figures: controls, keys and the pointer change them, and a link brings it back") {
  if (!can_look()) return;
  const auto figures = figures_that_move();
  if (figures.empty()) return skip("nothing was compiled for the browser");
  Chromium browser;
  browser.resize(1280, 1000);
  for (const Moving& moving : figures) {
    CAPTURE(moving.picture);
    browser.open(address_of(moving.page));
    REQUIRE(browser.evaluate(find(moving)) == true);
    const auto picture = [&] { return browser.evaluate("figure.place.innerHTML"); };
    browser.evaluate("figure.reset()");
    const Json still = picture();
    // As a reader does: each control, by its element.
    const int controls = browser.evaluate("figure.controls.length");
    for (int k = 0; k < controls; ++k) {
      browser.evaluate(
          "(() => { const e = figure.fields[" + std::to_string(k) +
          "].row.querySelector('input, select'); e.value = e.tagName === 'SELECT' ? "
          "(e.selectedIndex + 1) % e.options.length : "
          "(+e.value + +(e.value == e.max ? e.min : e.max)) / 2; "
          "e.dispatchEvent(new Event(e.tagName === 'SELECT' ? 'change' : 'input')); })()");
      CHECK(picture() != still);
      browser.evaluate("figure.reset()");
      CHECK(picture() == still);
    }
    if (browser.evaluate("figure.declared.drags") == true) {
      const Json free = browser.evaluate(place_of(false)), grip = browser.evaluate(place_of(true));
      const auto drag_from = [&](const Json& at) {
        const double x = at[0], y = at[1];
        browser.drag(x, y, x - 45, y - 35);
      };
      CHECK(browser.evaluate(what_covers_grips) == Json::array());
      drag_from(free);  // as a reader does to scroll
      CHECK(picture() == still);
      drag_from(grip);
      CHECK(picture() != still);
      const Json settings = browser.evaluate("[...figure.settings()]");
      const std::string link = browser.evaluate("(figure.writeLink(), location.href)");
      browser.open(link);
      REQUIRE(browser.evaluate(find(moving)) == true);
      const Json again = browser.evaluate("[...figure.settings()]");
      for (std::size_t k = 0; k < settings.size(); ++k)
        CHECK(std::abs(again[k].get<double>() - settings[k].get<double>()) < 1e-5);
    }
    const double frame = browser.evaluate(
        "(() => { const n = 30, begin = performance.now(); for (let i = 0; i < n; ++i) { "
        "figure.draw(); figure.place.getBoundingClientRect(); } return (performance.now() - begin) "
        "/ n; })()");
    MESSAGE(moving.picture << ": " << frame << " ms a frame");
    CHECK(browser.complaints() == std::vector<std::string>{});
  }
}
