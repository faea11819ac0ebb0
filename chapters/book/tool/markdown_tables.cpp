#include "book/tool/markdown_tables.hpp"

#include <cstddef>

#include "book/tool/fences.hpp"

namespace tumble::book {

namespace {

/// How many cells a line of a table has; 0 for any other line.
std::size_t cells_in(const std::string& line) {
  const std::string row = trimmed(line);
  if (row.size() < 2 || row.front() != '|' || row.back() != '|') return 0;
  std::size_t bars = 0;
  for (std::size_t i = 0; i < row.size(); ++i)
    bars += row[i] == '|' && (i == 0 || row[i - 1] != '\\');
  return bars - 1;
}

/// "|---|:-:|"
bool is_rule(const std::string& line) {
  return cells_in(line) > 0 && line.find_first_not_of("|-: ") == std::string::npos;
}

}  // namespace

std::vector<std::string> broken_rows(const Page& page) {
  const std::vector<Fence> fences = fences_of(page);
  std::vector<std::string> bad;
  std::size_t expected = 0;  // cells; 0 outside of tables
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const std::size_t cells = is_inside(fences, i) ? 0 : cells_in(unquoted(page.lines[i]));
    if (cells == 0) expected = 0;
    if (is_rule(unquoted(page.lines[i]))) expected = cells;
    if (expected != 0 && cells != expected)
      bad.push_back(at(page, i) + "this row has " + std::to_string(cells) +
                    " cells, and its heading has " + std::to_string(expected) +
                    "; is a | of the text not written as \\|?");
  }
  return bad;
}

}  // namespace tumble::book
