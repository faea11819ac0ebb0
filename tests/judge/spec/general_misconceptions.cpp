#include "judge/spec/general_misconceptions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "judge/spec/demand.hpp"

namespace tumble::judge {

namespace {

bool contains(const Value& value, bool (*kind)(double)) {
  if (const double* x = value.as<double>()) return kind(*x);
  const List* list = value.as<List>();
  return list && std::any_of(list->begin(), list->end(),
                             [&](const Value& each) { return contains(each, kind); });
}

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
  const List* rows = value.as<List>();
  if (!rows || rows->size() < 2) return std::nullopt;
  List result(rows->size(), List(rows->size()));
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const List* row = (*rows)[i].as<List>();
    if (!row || row->size() != rows->size()) return std::nullopt;
    for (std::size_t j = 0; j < row->size(); ++j) {
      if (!(*row)[j].as<double>()) return std::nullopt;
      std::get<List>(result[j].data)[i] = (*row)[j];
    }
  }
  return result;
}

/// How many numbers of a value are not zero: a name from one number alone would be a guess.
std::size_t count_nonzero(const Value& value) {
  if (const double* x = value.as<double>()) return *x != 0 ? 1 : 0;
  const List* list = value.as<List>();
  if (!list) return 0;
  std::size_t count = 0;
  for (const Value& each : *list) count += count_nonzero(each);
  return count;
}

bool is_argument(const Finding& finding) {
  if (!finding.question || count_nonzero(*finding.answer) < 2) return false;
  const List& arguments = finding.question->arguments;
  return std::any_of(arguments.begin(), arguments.end(), [&](const Value& argument) {
    return argument.as<List>() && largest_difference(argument, *finding.answer) == 0;
  });
}

}  // namespace

std::vector<Misconception> general_misconceptions(const Finding& finding) {
  if (finding.outcome != Outcome::wrong || !finding.answer) return {};
  const Value& answer = *finding.answer;
  if (contains(answer, [](double x) { return std::isnan(x); }))
    return {{"not a number",
             "Your answer contains NaN: somewhere 0 is divided by 0, or a root or an arc cosine is "
             "taken "
             "of what it is not defined for. Look for a divisor that these arguments make zero.",
             ""}};
  if (contains(answer, [](double x) { return std::isinf(x); }))
    return {{"infinite",
             "Your answer contains infinity: something is divided by 0, or grows without end.",
             ""}};
  if (is_argument(finding))
    return {{"the argument as it came", "Your answer is one of the arguments, unchanged.", ""}};
  if (!finding.demanded) return {};
  const Value& demanded = *finding.demanded;
  const auto meets = [&](const Value& value) {
    return largest_difference(value, demanded) <= finding.tolerance;
  };
  if (const auto rows_for_columns = transposed(answer);
      rows_for_columns && meets(*rows_for_columns))
    return {{"rows for columns", "Your matrix is the transpose of the one that is demanded.", ""}};
  if (count_nonzero(demanded) >= 2 && meets(negated(answer)))
    return {{"the opposite sign",
             "Every number of your answer has the wrong sign, and the right size.", ""}};
  return {};
}

}  // namespace tumble::judge
