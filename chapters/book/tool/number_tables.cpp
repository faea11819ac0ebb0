#include "book/tool/number_tables.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "book/tool/page.hpp"
#include "book/tool/wording.hpp"
#include "support/svg.hpp"

namespace tumble::book {

namespace {

using Characters = std::vector<std::string>;  // of UTF-8

Characters characters_of(const std::string& line) {
  Characters characters;
  for (const char c : line) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
    if (continues && !characters.empty())
      characters.back() += c;
    else
      characters.emplace_back(1, c);
  }
  return characters;
}

struct Column {
  std::size_t begin = 0, end = 0;
  bool holds_text = false;
};

/// One column per run of ─; none if anything else is in the line.
std::vector<Column> columns_under(const Characters& rule) {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < rule.size(); ++i) {
    if (rule[i] != "─" && rule[i] != " ") return {};
    if (rule[i] != "─") continue;
    if (columns.empty() || columns.back().end != i) columns.push_back({i, i});
    columns.back().end = i + 1;
  }
  return columns;
}

using Row = std::vector<std::string>;

/// The cells of a line; none if a character is between two columns.
Row cells_of(const Characters& line, const std::vector<Column>& columns) {
  Row cells;
  std::size_t used = 0;
  for (const Column& column : columns) {
    std::string cell;
    for (std::size_t i = column.begin; i < std::min(column.end, line.size()); ++i) {
      cell += line[i];
      used += line[i] != " ";
    }
    cells.push_back(trimmed(cell));
  }
  const auto there = line.size() - static_cast<std::size_t>(
                                       std::count(line.begin(), line.end(), std::string(" ")));
  return used == there ? cells : Row{};
}

/// A number, "< 1e-14", or nothing.
bool is_number_cell(const std::string& cell) {
  if (cell.empty() || cell == "–" || cell == "-") return true;
  if (std::isalpha(static_cast<unsigned char>(cell[0]))) return false;  // RK4
  const bool compared = cell.starts_with("< ") || cell.starts_with("> ");
  const std::size_t from = compared ? 2 : 0, digit = cell.find_first_of("0123456789", from);
  return digit < from + 6 && digit <= cell.find(' ', from);
}

/// A line that only goes on with the words above it belongs to their row: "0, 0)" too.
std::vector<Row> joined(const std::vector<Row>& lines) {
  std::vector<Row> rows;
  for (const Row& line : lines) {
    const auto words = std::find_if(line.begin(), line.end(),
                                    [](const std::string& cell) { return !cell.empty(); });
    const auto k = static_cast<std::size_t>(words - line.begin());
    const bool alone = std::count(line.begin(), line.end(), "") + 1 == std::ssize(line);
    const auto are_words = [k](const Row& row) { return !is_number_cell(row[k]); };
    const bool may_go_on = rows.size() > 1 && k > 0 && alone && !rows.back()[k].empty();
    if (may_go_on && (are_words(line) || are_words(rows.back())))
      rows.back()[k] += " " + line[k];
    else
      rows.push_back(line);
  }
  return rows;
}

/// Words begin at the left. Numbers end at the right, and so does a word in their place ("exact"),
/// however often it is there.
bool holds_text(std::size_t k, const std::vector<Row>& rows) {
  std::vector<std::string> words;
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (!is_number_cell(rows[i][k])) words.push_back(rows[i][k]);
  const bool names_rows = k == 0;
  if (names_rows) return !words.empty();
  const bool all_alike = std::all_of(words.begin(), words.end(),
                                     [&](const std::string& each) { return each == words[0]; });
  return 2 * words.size() > rows.size() - 1 && !all_alike;
}

std::string cell_html(const std::string& cell) {
  return with_indices(with_whole_formulas(support::svg_minus_signs(cell)));
}

/// The class of a cell: whole sentences take more than one line.
std::string class_of(const std::string& cell, const Column& column) {
  constexpr std::size_t long_text = 60;
  if (!column.holds_text) return ">";
  return cell.size() > long_text ? " class=\"words long\">" : " class=\"words\">";
}

std::string row_html(const Row& cells, const std::vector<Column>& columns, const std::string& tag) {
  std::string html = "<tr>";
  for (std::size_t k = 0; k < cells.size(); ++k)
    html.append("<")
        .append(tag)
        .append(class_of(cells[k], columns[k]))
        .append(cell_html(cells[k]))
        .append("</")
        .append(tag)
        .append(">");
  return html + "</tr>";
}

}  // namespace

std::string number_table_html(const std::string& text) {
  std::vector<Characters> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(characters_of(line));
  if (lines.size() < 3) return {};
  std::vector<Column> columns = columns_under(lines[1]);
  if (columns.empty()) return {};
  lines.erase(lines.begin() + 1);
  std::vector<Row> rows;
  rows.reserve(lines.size());
  for (const Characters& line : lines) rows.push_back(cells_of(line, columns));
  if (std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.empty(); })) return {};
  rows = joined(rows);
  for (std::size_t k = 0; k < columns.size(); ++k) columns[k].holds_text = holds_text(k, rows);
  std::string html = R"(<div class="scroll" tabindex="0"><table class="numbers"><thead>)" +
                     row_html(rows[0], columns, "th") + "</thead><tbody>";
  for (std::size_t i = 1; i < rows.size(); ++i) html += row_html(rows[i], columns, "td");
  return html + "</tbody></table></div>";
}

}  // namespace tumble::book
