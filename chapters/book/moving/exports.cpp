/// @file
/// What a page calls: a chapter's figures, compiled for the browser. TUMBLE_FIGURES lists them, and
/// TUMBLE_CHAPTER is where they are declared. Texts are handed over as a place in memory, and their
/// length by text_size().

#include <cstddef>
#include <string>

#include "support/moving_declaration.hpp"
#include TUMBLE_CHAPTER

namespace {

using tumble::support::MovingFigure;

/// In the order of the page's list.
constexpr const MovingFigure* figures[] = {TUMBLE_FIGURES};

/// The settings of each figure, and the last text.
struct Pages {
  std::vector<std::vector<double>> settings;
  std::string text;
};

Pages& pages() {
  static Pages all = [] {
    Pages made;
    for (const MovingFigure* figure : figures)
      made.settings.push_back(tumble::support::start_of(*figure));
    return made;
  }();
  return all;
}

const MovingFigure& figure(int i) { return *figures[i]; }
std::vector<double>& settings(int i) { return pages().settings[static_cast<std::size_t>(i)]; }

const char* hand_over(std::string text) {
  pages().text = std::move(text);
  return pages().text.data();
}

}  // namespace

extern "C" {

/// A figure and its controls, as JSON.
[[clang::export_name("declaration")]] const char* declaration(int i) {
  return hand_over(tumble::support::declaration_of(figure(i)));
}
/// The figure's settings, one double each: the page reads and writes them.
[[clang::export_name("settings")]] double* settings_of(int i) { return settings(i).data(); }
/// The picture with the settings as they are: SVG.
[[clang::export_name("draw")]] const char* draw(int i) {
  return hand_over(figure(i).draw(settings(i)));
}
/// A pointer was pressed or moved on the picture: changes the settings.
[[clang::export_name("drag")]] void drag(int i, double x, double y, double dx, double dy) {
  figure(i).drag(settings(i), {x, y, dx, dy});
}
[[clang::export_name("text_size")]] std::size_t text_size() { return pages().text.size(); }
}
