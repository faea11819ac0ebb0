/// @file
/// What a page calls: a figure, compiled for the browser. TUMBLE_FIGURE is its name, and
/// TUMBLE_CHAPTER where it is declared. Texts are handed over as a place in memory, and their
/// length by text_size().

#include <cstddef>
#include <string>

#include "support/moving_declaration.hpp"
#include TUMBLE_CHAPTER

namespace {

constexpr const tumble::support::MovingFigure& figure = TUMBLE_FIGURE;

/// The settings, and the last text.
struct Page {
  std::vector<double> settings = tumble::support::start_of(figure);
  std::string text;
  std::vector<double> states;  ///< what is asked of another's functions, and what they gave
};

Page& page() {
  static Page only;
  return only;
}

const char* hand_over(std::string text) {
  page().text = std::move(text);
  return page().text.data();
}

}  // namespace

extern "C" {

/// The figure and its controls, as JSON.
[[clang::export_name("declaration")]] const char* declaration() {
  return hand_over(tumble::support::declaration_of(figure));
}
/// The figure's settings, one double each: the page reads and writes them.
[[clang::export_name("settings")]] double* settings() { return page().settings.data(); }
/// The picture with the settings as they are: SVG.
[[clang::export_name("draw")]] const char* draw() {
  return hand_over(figure.draw(page().settings));
}
/// A pointer was pressed or moved on the picture: changes the settings.
[[clang::export_name("drag")]] void drag(double x, double y, double dx, double dy) {
  figure.drag(page().settings, {x, y, dx, dy});
}
/// What the figure asks of another's functions, 26 numbers; none if it shows its own motion only.
[[clang::export_name("question")]] const double* question() {
  if (!figure.given) return nullptr;
  page().states = figure.given->question(page().settings);
  return page().states.data();
}
/// Room for the numbers of a motion: the page writes them, and calls take().
[[clang::export_name("states")]] double* states(std::size_t count) {
  page().states.resize(count);
  return page().states.data();
}
/// Shows the given motion, or its own again if there is none.
[[clang::export_name("take")]] void take() {
  if (figure.given) figure.given->take(page().states);
}
[[clang::export_name("text_size")]] std::size_t text_size() { return page().text.size(); }
}
