#include "judge/verdict/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace tumble::judge {

namespace {

std::string number_text(double x, int digits) {
  if (std::isnan(x)) return "NaN";
  if (std::isinf(x)) return x > 0 ? "infinity" : "-infinity";
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

bool is_matrix(const List& list) {
  return !list.empty() && std::all_of(list.begin(), list.end(), [](const Value& row) {
    const List* numbers = row.as<List>();
    return numbers && !numbers->empty() && numbers->front().as<double>();
  });
}

std::string matrix_text(const List& rows, int digits, std::size_t indent) {
  std::vector<std::vector<std::string>> cells;
  std::size_t width = 0;
  for (const Value& row : rows) {
    cells.emplace_back();
    for (const Value& entry : *row.as<List>()) {
      cells.back().push_back(text_of(entry, digits));
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

std::string list_text(const List& list, int digits) {
  constexpr std::size_t most = 24;
  std::string text = "(";
  for (std::size_t i = 0; i < std::min(list.size(), most); ++i)
    text += (i > 0 ? ", " : "") + text_of(list[i], digits);
  if (list.size() > most) text += ", … " + std::to_string(list.size()) + " entries in all";
  return text + ")";
}

}  // namespace

std::string text_of(const Value& value, int digits, std::size_t indent) {
  if (const double* x = value.as<double>()) return number_text(*x, digits);
  if (const std::int64_t* n = value.as<std::int64_t>()) return std::to_string(*n);
  if (const std::string* text = value.as<std::string>()) return "\"" + *text + "\"";
  if (value.as<FunctionId>()) return "a function of the judge";
  const List& list = *value.as<List>();
  return is_matrix(list) ? matrix_text(list, digits, indent) : list_text(list, digits);
}

}  // namespace tumble::judge
