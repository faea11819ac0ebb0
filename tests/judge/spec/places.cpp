#include "judge/spec/places.hpp"

#include <algorithm>
#include <cctype>

#include "judge/spec/demand.hpp"

namespace tumble::judge {

namespace {

/// @return whether nothing but numbers was found
bool collect_numbers(const Value& value, std::vector<double>& numbers) {
  if (const double* x = value.as<double>()) numbers.push_back(*x);
  const List* list = value.as<List>();
  if (!list) return value.as<double>();
  return std::all_of(list->begin(), list->end(),
                     [&](const Value& each) { return collect_numbers(each, numbers); });
}

bool has_same_shape(const Value& a, const Value& b) {
  const List *x = a.as<List>(), *y = b.as<List>();
  if (!x || !y) return !x && !y;
  return std::equal(x->begin(), x->end(), y->begin(), y->end(), has_same_shape);
}

/// "row 1, column 2", "row 0, column 1 and row 1, column 0"
std::string text_in_matrix(const Places& places, std::size_t size) {
  std::string text;
  for (const std::size_t place : places)
    text += (text.empty() ? "row " : " and row ") + std::to_string(place / size) + ", column " +
            std::to_string(place % size);
  return text;
}

}  // namespace

std::optional<std::vector<double>> numbers_in(const Value& value) {
  std::vector<double> numbers;
  if (!collect_numbers(value, numbers)) return std::nullopt;
  return numbers;
}

std::size_t count_nonzero(const Value& value) {
  if (const double* x = value.as<double>()) return *x != 0 ? 1 : 0;
  const List* list = value.as<List>();
  if (!list) return 0;
  std::size_t count = 0;
  for (const Value& each : *list) count += count_nonzero(each);
  return count;
}

bool is_vector(const Value& value) {
  const List* list = value.as<List>();
  return list && std::all_of(list->begin(), list->end(),
                             [](const Value& each) { return each.as<double>(); });
}

bool is_square_matrix(const Value& value) {
  const List* rows = value.as<List>();
  return rows && std::all_of(rows->begin(), rows->end(), [&](const Value& each) {
           return is_vector(each) && each.as<List>()->size() == rows->size();
         });
}

std::optional<Places> wrong_places(const Finding& finding) {
  if (!finding.answer || !finding.demanded || !has_same_shape(*finding.answer, *finding.demanded))
    return std::nullopt;
  const auto answer = numbers_in(*finding.answer), demanded = numbers_in(*finding.demanded);
  if (!answer || !demanded) return std::nullopt;
  Places places;
  for (std::size_t i = 0; i < answer->size(); ++i)
    if (!(largest_difference((*answer)[i], (*demanded)[i]) <= finding.tolerance))
      places.push_back(i);
  return places;
}

std::string text_of(const Places& places) {
  constexpr std::size_t most_runs = 3;
  std::vector<std::string> runs;
  for (std::size_t i = 0; i < places.size();) {
    std::size_t last = i;
    while (last + 1 < places.size() && places[last + 1] == places[last] + 1) ++last;
    runs.push_back(std::to_string(places[i]) +
                   (last > i ? " to " + std::to_string(places[last]) : ""));
    i = last + 1;
  }
  std::string text = (places.size() == 1 ? "place " : "places ") + runs.front();
  for (std::size_t i = 1; i < std::min(runs.size(), most_runs); ++i)
    text += (i + 1 == runs.size() ? " and " : ", ") + runs[i];
  return text + (runs.size() > most_runs ? ", …" : "");
}

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string text_of(const Places& places, const Value& answer) {
  constexpr std::size_t most_of_a_matrix = 2;
  if (is_vector(answer)) return text_of(places);
  if (is_square_matrix(answer) && places.size() <= most_of_a_matrix)
    return text_in_matrix(places, answer.as<List>()->size());
  return places.size() == 1 ? "one number" : std::to_string(places.size()) + " numbers";
}

}  // namespace tumble::judge
