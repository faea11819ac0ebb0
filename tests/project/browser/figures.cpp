/// @file
/// The figures of the chapters, as Chromium draws them: you can read every word.
#include <doctest/doctest.h>

#include <filesystem>
#include <set>

#include "project/browser/site.hpp"

using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

/// What is wrong with the words of a drawing, each once. A line below them is no harm where they
/// have a rim of paper; one that is drawn later is.
const char* const unreadable = R"js((() => {
  const all = [...document.querySelectorAll("svg *:not(defs *, clipPath *)")];
  const order = new Map(all.map((e, i) => [e, i]));
  const size = document.documentElement.getBoundingClientRect();
  /** Where the letters are, without the space above and below them. */
  const letters = (e) => {
    const { left, right, top, bottom, height } = e.getBoundingClientRect();
    return { left: left + 1, right: right - 1, top: top + 0.22 * height, bottom: bottom - 0.2 * height };
  };
  const words = all.filter((e) => e.tagName === "text" && e.textContent.trim() !== "")
    .map((e) => ({ e, name: e.textContent.trim(), box: letters(e), rim: e.getAttribute("paint-order") === "stroke" }));
  const isLine = (e) => {
    const { stroke, strokeOpacity, opacity } = getComputedStyle(e);
    return e instanceof SVGGeometryElement && stroke !== "none" && stroke !== "rgba(0, 0, 0, 0)" &&
      strokeOpacity * opacity > 0.05 && e.getTotalLength() > 0;
  };
  /** A point for each pixel of its way. */
  const pointsOf = (e) => {
    const to = e.getScreenCTM(), long = e.getTotalLength(), n = Math.min(6000, Math.max(2, Math.ceil(long)));
    return Array.from({ length: n + 1 }, (_, i) => e.getPointAtLength(long * i / n).matrixTransform(to));
  };
  const found = new Set();
  for (const line of all.filter(isLine)) {
    const points = pointsOf(line);
    for (const { e, name, box, rim } of words) {
      if (rim && order.get(line) < order.get(e)) continue;
      const inside = points.filter(({ x, y }) => x > box.left && x < box.right && y > box.top && y < box.bottom);
      if (inside.length > 1) found.add(`a line goes through “${name}”`);
    }
  }
  words.forEach(({ name, box }, i) => {
    if (box.left < -1 || box.top < -1 || box.right > size.right + 1 || box.bottom > size.bottom + 1)
      found.add(`“${name}” leaves the picture`);
    for (const other of words.slice(i + 1)) {
      const wide = Math.min(box.right, other.box.right) - Math.max(box.left, other.box.left);
      const high = Math.min(box.bottom, other.box.bottom) - Math.max(box.top, other.box.top);
      if (wide > 1 && high > 1) found.add(`“${name}” lies on “${other.name}”`);
    }
  });
  return [...found];
})())js";

/// Ten letters of the font that figures get, and what they take in Debian's, for which there is
/// room: it is one of the widest [px].
const char* const width_of_ten_m = R"js((() => {
  const pen = document.querySelector("canvas").getContext("2d");
  pen.font = "100px system-ui";
  return Math.round(pen.measureText("mmmmmmmmmm").width);
})())js";
constexpr int width_in_dejavu = 974;

/// The drawings of all chapters.
std::set<fs::path> figures() {
  const char* root = std::getenv("TUMBLE_ROOT");
  tumble::require(root != nullptr, "ctest sets TUMBLE_ROOT");
  std::set<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(root) / "chapters"))
    if (entry.path().extension() == ".svg") found.insert(entry.path());
  return found;
}

}  // namespace

TEST_CASE("figures: no line goes through a word, no word lies on another or leaves the picture") {
  if (chromium_program().empty()) return skip("there is no Chromium");
  Chromium browser;
  browser.open("data:text/html,<canvas>");
  if (browser.evaluate(width_of_ten_m) != width_in_dejavu)
    return skip("words have other widths here: system-ui is not DejaVu Sans");
  for (const fs::path& figure : figures()) {
    CAPTURE(figure);
    browser.open("file://" + figure.string());
    CHECK(browser.evaluate(unreadable) == nlohmann::json::array());
  }
}

TEST_CASE("figures: words that cannot be read are found") {
  if (chromium_program().empty()) return skip("there is no Chromium");
  Chromium browser;
  const std::string line = R"(<path d="M0 45h100" stroke="black"/>)";
  const std::string rim = R"( stroke="white" stroke-width="4" paint-order="stroke")";
  const auto said_of = [&](const std::string& drawing) {
    browser.open(
        "data:image/svg+xml,<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" "
        "height=\"60\">" +
        drawing + "</svg>");
    return browser.evaluate(unreadable);
  };
  const auto word = [](const std::string& text, const std::string& x, const std::string& look) {
    return "<text x=\"" + x + "\" y=\"50\"" + look + ">" + text + "</text>";
  };
  using Json = nlohmann::json;
  CHECK(said_of(line + word("one", "9", "")) == Json{"a line goes through “one”"});
  CHECK(said_of(line + word("one", "9", rim)) == Json::array());
  CHECK(said_of(word("one", "9", rim) + line) == Json{"a line goes through “one”"});
  CHECK(said_of(word("one", "9", "") + word("two", "20", "")) == Json{"“one” lies on “two”"});
  CHECK(said_of(word("one", "90", "")) == Json{"“one” leaves the picture"});
}
