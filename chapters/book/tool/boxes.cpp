#include "book/tool/boxes.hpp"

#include <array>

#include "book/tool/fences.hpp"

namespace tumble::book {

namespace {

const std::string now_write = "> **Now write ";

/// The style of a box that begins with this line; empty for any other quotation.
std::string style_of(const std::string& line) {
  using Style = std::array<std::string, 2>;
  static const std::array<Style, 3> styles{Style{now_write, "now-write"},
                                           {"> **Try it.**", "try-it"},
                                           {"> **For the curious", "curious"}};
  for (const auto& [start, name] : styles)
    if (line.starts_with(start)) return name;
  return {};
}

/// "4.1" of "> **Now write 4.1: …".
std::string exercise_in(const std::string& line) {
  if (!line.starts_with(now_write)) return {};
  return line.substr(now_write.size(), line.find(':') - now_write.size());
}

/// Whether a list ends above this line. The empty line between the list and a box becomes the edge
/// of the box, and Doxygen would take the box for a part of the last item.
bool is_below_a_list(const std::vector<std::string>& lines, std::size_t i) {
  while (i > 1 && lines[i - 1].starts_with("  ")) --i;
  const std::string item = i > 0 ? lines[i - 1] : "";
  const std::size_t dot = item.find_first_not_of("0123456789");
  return item.starts_with("- ") ||
         (dot != 0 && dot != std::string::npos && item.substr(dot, 2) == ". ");
}

}  // namespace

std::string box_id(const std::string& exercise) { return "now-write-" + exercise; }

std::vector<Box> boxes_of(const Page& page) {
  const std::vector<std::string>& lines = page.lines;
  const std::vector<Fence> fences = fences_of(page);
  const auto goes_on = [&](std::size_t i) { return i < lines.size() && is_quoted(lines[i]); };
  std::vector<Box> boxes;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!is_quoted(lines[i]) || is_inside(fences, i)) continue;
    Box box{i, i, style_of(lines[i]), exercise_in(lines[i])};
    while (goes_on(box.end)) ++box.end;
    i = box.end;
    if (box.name.empty()) continue;
    if (!lines[box.first - 1].empty() && !lines[box.first - 1].starts_with("<!--"))
      fail(page, box.first, "the line above a box is empty, or a comment");
    if (lines[box.first - 1].empty() && is_below_a_list(lines, box.first - 1))
      fail(page, box.first, "a paragraph is missing between a list and a box");
    if (box.end == lines.size() || !lines[box.end].empty())
      fail(page, box.end - 1, "the line below a box is empty");
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace tumble::book
