#include "book/tool/figures.hpp"

#include "book/tool/fences.hpp"
#include "book/tool/links.hpp"

namespace tumble::book {

namespace {

/// Fills in the caption, if the lines two below the picture are a paragraph in italics.
void read_caption(const std::vector<std::string>& lines, Figure& figure) {
  const std::size_t first = figure.line + 2;
  if (first >= lines.size() || !lines[figure.line + 1].empty()) return;
  std::size_t end = first;
  std::string text;
  for (; end < lines.size() && !lines[end].empty(); ++end)
    text += (end > first ? " " : "") + lines[end];
  const bool italics = text.size() > 2 && text[0] == '*' && text[1] != '*' && text.back() == '*';
  if (!italics) return;
  figure.first = first;
  figure.end = end;
  figure.caption = text.substr(1, text.size() - 2);
}

}  // namespace

std::vector<Figure> figures_of(const Page& page) {
  std::vector<Figure> figures;
  const std::vector<Fence> fences = fences_of(page);
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    if (is_inside(fences, i)) continue;
    const std::vector<Link> links = links_in(page.lines[i]);
    if (links.size() != 1 || !links[0].image || links[0].begin != 0) continue;
    Figure figure;
    figure.line = figure.first = figure.end = i;
    figure.picture = links[0].target;
    figure.alternative = links[0].text;
    read_caption(page.lines, figure);
    figures.push_back(figure);
  }
  return figures;
}

}  // namespace tumble::book
