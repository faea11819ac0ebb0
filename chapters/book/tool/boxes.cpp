#include "book/tool/boxes.hpp"

#include <array>

namespace tumble::book {

namespace {

/// The style of a box that begins with this line; empty for any other quotation.
std::string style_of(const std::string& line) {
  using Style = std::array<std::string, 2>;
  static const std::array<Style, 3> styles{Style{"> **Now write ", "now-write"},
                                           {"> **Try it.**", "try-it"},
                                           {"> **For the curious", "curious"}};
  for (const auto& [start, name] : styles)
    if (line.starts_with(start)) return name;
  return {};
}

}  // namespace

std::vector<Box> boxes_of(const Page& page) {
  const std::vector<std::string>& lines = page.lines;
  const std::vector<Fence> fences = fences_of(page);
  const auto goes_on = [&](std::size_t i) { return i < lines.size() && is_quoted(lines[i]); };
  std::vector<Box> boxes;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!is_quoted(lines[i]) || is_inside(fences, i)) continue;
    Box box{i, i, style_of(lines[i])};
    while (goes_on(box.end)) ++box.end;
    i = box.end;
    if (box.name.empty()) continue;
    if (!lines[box.first - 1].empty() && !lines[box.first - 1].starts_with("<!--"))
      fail(page, box.first, "the line above a box is empty, or a comment");
    if (box.end == lines.size() || !lines[box.end].empty())
      fail(page, box.end - 1, "the line below a box is empty");
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace tumble::book
