#include "judge/spec/likeness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "judge/spec/demand.hpp"
#include "judge/spec/places.hpp"

namespace tumble::judge {

namespace {

Value negated(const Value& value) {
  if (const double* x = value.as<double>()) return -*x;
  if (const std::int64_t* n = value.as<std::int64_t>()) return -*n;
  const List* list = value.as<List>();
  if (!list) return value;
  List result;
  for (const Value& each : *list) result.push_back(negated(each));
  return result;
}

/// The transpose of a square matrix of at least two rows; nothing of anything else.
std::optional<Value> transposed(const Value& value) {
  if (!is_square_matrix(value) || value.as<List>()->size() < 2) return std::nullopt;
  List result = *value.as<List>();
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      std::swap(std::get<List>(result[i].data)[j], std::get<List>(result[j].data)[i]);
  return result;
}

bool is_argument(const Finding& finding) {
  return finding.question && count_nonzero(*finding.answer) >= 2 &&
         equals_argument(finding.question->arguments, *finding.answer);
}

/// A beginning or an end of a list that is 0, where all else is right: a loop that leaves it out,
/// over a vector that began with zeros.
std::optional<Misconception> left_at_zero(const Finding& finding) {
  const std::optional<Places> wrong = wrong_places(finding);
  if (!wrong || wrong->size() < 2 || !is_vector(*finding.answer)) return std::nullopt;
  const List& answer = *finding.answer->as<List>();
  if (answer.size() < of_a_loop) return std::nullopt;
  const bool is_run = wrong->back() - wrong->front() + 1 == wrong->size(),
             is_at_an_end = wrong->front() == 0 || wrong->back() + 1 == answer.size(),
             is_zero = std::all_of(wrong->begin(), wrong->end(),
                                   [&](std::size_t i) { return *answer[i].as<double>() == 0; });
  if (!is_run || !is_at_an_end || !is_zero || count_nonzero(*finding.answer) < 2)
    return std::nullopt;
  return Misconception{left_at_zero_name,
                       capitalised(text_of(*wrong)) +
                           " of your answer (counted from 0) are 0, and all others are right. " +
                           look_at_the_loops,
                       ""};
}

}  // namespace

bool is_unchanged(const Value& argument, const Value& answer) {
  return argument.data.index() == answer.data.index() && largest_difference(argument, answer) == 0;
}

bool equals_argument(const List& arguments, const Value& answer) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [&](const Value& argument) { return is_unchanged(argument, answer); });
}

Misconception argument_unchanged() {
  return {argument_as_it_came, "Your answer is one of the arguments, unchanged.", ""};
}

std::vector<Misconception> names_of_likeness(const Finding& finding) {
  const Value& answer = *finding.answer;
  if (is_argument(finding)) return {argument_unchanged()};
  if (!finding.demanded) return {};
  const Value& demanded = *finding.demanded;
  const auto meets = [&](const Value& value) {
    return largest_difference(value, demanded) <= finding.tolerance;
  };
  const std::optional<Value> other_way = transposed(answer);
  const bool is_transpose = other_way && meets(*other_way), is_negative = meets(negated(answer));
  if (is_transpose && is_negative) return {};  // of a skew-symmetric matrix: it may be either
  if (is_transpose)
    return {{"rows for columns", "Your matrix is the transpose of the one that is demanded.", ""}};
  if (is_negative && count_nonzero(demanded) >= 2)
    return {{"the opposite sign",
             "Every number of your answer has the wrong sign, and the right size.", ""}};
  if (const std::optional<Misconception> left = left_at_zero(finding)) return {*left};
  return {};
}

}  // namespace tumble::judge
