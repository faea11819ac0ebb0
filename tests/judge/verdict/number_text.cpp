#include "judge/verdict/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "support/printable.hpp"

namespace tumble::judge {

namespace {

std::string number_text(double x, int digits) {
  if (std::isnan(x)) return "NaN";
  if (std::isinf(x)) return x > 0 ? "infinity" : "-infinity";
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

constexpr std::size_t most_text = 60;  // bytes of a text inside a value
constexpr int most_nesting = 3;

std::string entry_text(const Value& value, int digits, int nesting);

std::string list_text(const List& list, int digits, int nesting) {
  if (nesting >= most_nesting) return "(…)";
  std::string text = "(";
  const std::size_t shown =
      list.size() <= most_numbers_shown + 1 ? list.size() : most_numbers_shown;
  for (std::size_t i = 0; i < shown; ++i)
    text += (i > 0 ? ", " : "") + entry_text(list[i], digits, nesting + 1);
  if (list.size() > shown) text += ", … " + std::to_string(list.size()) + " entries in all";
  return text + ")";
}

std::string entry_text(const Value& value, int digits, int nesting) {
  if (const double* x = value.as<double>()) return number_text(*x, digits);
  if (const std::int64_t* n = value.as<std::int64_t>()) return std::to_string(*n);
  if (const std::string* text = value.as<std::string>()) {
    std::string quoted = "\"";
    return quoted.append(one_line(*text, most_text)).append("\"");
  }
  if (value.as<FunctionId>()) return "a function of the judge";
  return list_text(*value.as<List>(), digits, nesting);
}

/// Rows of numbers, all of the same small size: anything else is shown as a list.
bool is_matrix(const List& rows) {
  if (rows.empty() || rows.size() > most_numbers_shown) return false;
  const List* first = rows.front().as<List>();
  if (!first || first->empty() || first->size() > most_numbers_shown) return false;
  return std::all_of(rows.begin(), rows.end(), [&](const Value& row) {
    const List* numbers = row.as<List>();
    return numbers && numbers->size() == first->size() &&
           std::all_of(numbers->begin(), numbers->end(),
                       [](const Value& entry) { return entry.as<double>() != nullptr; });
  });
}

std::string matrix_text(const List& rows, int digits, std::size_t indent) {
  std::vector<std::vector<std::string>> cells;
  std::size_t width = 0;
  for (const Value& row : rows) {
    cells.emplace_back();
    for (const Value& entry : *row.as<List>()) {
      cells.back().push_back(number_text(*entry.as<double>(), digits));
      width = std::max(width, cells.back().back().size());
    }
  }
  std::string text;
  for (const auto& row : cells) {
    text += (text.empty() ? "" : "\n" + std::string(indent, ' ')) + "[";
    for (const std::string& cell : row) text += std::string(width + 2 - cell.size(), ' ') + cell;
    text += "  ]";
  }
  return text;
}

}  // namespace

std::string text_of(const Value& value, int digits, std::size_t indent) {
  const List* list = value.as<List>();
  return list && is_matrix(*list) ? matrix_text(*list, digits, indent)
                                  : entry_text(value, digits, 0);
}

std::string printable(const std::string& text) {
  std::string clean;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t bad = support::unprintable_bytes(text, i);
    clean += bad > 0 ? '?' : text[i];
    i += std::max<std::size_t>(bad, 1);
  }
  return clean;
}

std::string one_line(const std::string& text, std::size_t most) {
  std::string line = printable(text.substr(0, most));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return line + (text.size() > most ? "…" : "");
}

}  // namespace tumble::judge
