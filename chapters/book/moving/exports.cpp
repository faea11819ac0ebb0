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
  std::vector<double> numbers;  ///< a question to the reader's functions, or their answer
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
/// What the figure asks the reader's functions, numbers_size() numbers.
[[clang::export_name("question")]] const double* question() {
  page().numbers.clear();
  if (figure.reader) page().numbers = figure.reader->question(page().settings);
  return page().numbers.data();
}
[[clang::export_name("numbers_size")]] std::size_t numbers_size() { return page().numbers.size(); }
/// Room for an answer: the page writes it, and calls take().
[[clang::export_name("room")]] double* room(std::size_t count) {
  page().numbers.resize(count);
  return page().numbers.data();
}
[[clang::export_name("take")]] void take() {
  if (figure.reader) figure.reader->take(page().settings, page().numbers);
}
[[clang::export_name("text_size")]] std::size_t text_size() { return page().text.size(); }
}
