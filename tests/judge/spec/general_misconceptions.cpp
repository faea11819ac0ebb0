#include "judge/spec/general_misconceptions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

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

/// Whether this is a list of as many lists of numbers, each as long.
bool is_square_matrix(const Value& value) {
  const List* rows = value.as<List>();
  return rows && std::all_of(rows->begin(), rows->end(), [&](const Value& each) {
           const List* row = each.as<List>();
           return row && row->size() == rows->size() &&
                  std::all_of(row->begin(), row->end(),
                              [](const Value& x) { return x.as<double>(); });
         });
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

/// Whether a number carries the mark of memory that was never set: gcc fills with 0xfe, clang with
/// 0xaa, and with 0xff where that is NaN. (Eigen's own matrices get the NaN that computing gives as
/// well.)
bool is_marked(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  constexpr std::uint64_t without_sign = ~std::uint64_t{0} >> 1;
  // 0xfefe… is −5.3e303; sums with it, and products with numbers of usual size, are about as large.
  const bool is_near = std::abs(x) > 5e300 && std::abs(x) < 5e306;
  return std::isfinite(x) ? is_near || bits == 0xaaaaaaaaaaaaaaaaull
                          : (bits & without_sign) == without_sign;
}

/// The same of a float that was never set, as a double: 0xfefefefe is −1.7e38.
bool is_marked_float(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  constexpr std::uint64_t without_sign = ~std::uint64_t{0} >> 1, all_of_float = 0x7fffffffe0000000;
  const bool is_near = std::abs(x) > 0.8e38 && std::abs(x) < 3.5e38;
  return std::isfinite(x) ? is_near : (bits & without_sign) == all_of_float;
}

bool contains_mark(const Value& value) {
  if (const double* x = value.as<double>()) return is_marked(*x);
  if (const std::int64_t* n = value.as<std::int64_t>())
    return *n == static_cast<std::int32_t>(0xfefefefe) ||
           *n == static_cast<std::int32_t>(0xaaaaaaaa);
  const List* list = value.as<List>();
  return list && std::any_of(list->begin(), list->end(), contains_mark);
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
  return finding.question && count_nonzero(*finding.answer) >= 2 &&
         equals_argument(finding.question->arguments, *finding.answer);
}

bool is_huge(double x) { return std::abs(x) > 1e150; }
bool is_large(double x) { return std::abs(x) > 1e30; }
bool is_nan(double x) { return std::isnan(x); }

/// The NaN that Eigen fills new matrices with, where computing gives another one: 0/0 has a sign on
/// x86 and none elsewhere. (Minus 0/0 has none either: it may be this one.)
bool is_nan_of_new_matrix(double x) {
  volatile double zero = 0;
  const double computed = zero / zero;
  return std::isnan(x) && std::signbit(computed) && !std::signbit(x);
}
bool is_infinite(double x) { return std::isinf(x); }

/// Whether an argument, or what a given function returned, has such a number.
bool is_given(const Finding& finding, bool (*kind)(double)) {
  if (!finding.question) return false;
  const std::vector<Evaluation>& told = finding.question->first_evaluations;
  return contains(finding.question->arguments, kind) ||
         std::any_of(told.begin(), told.end(),
                     [&](const Evaluation& each) { return contains(each.result, kind); });
}

/// Whether what was given or the right answer has numbers so large that a mark is none.
bool is_about(const Finding& finding, bool (*kind)(double)) {
  return is_given(finding, kind) || (finding.demanded && contains(*finding.demanded, kind));
}

using Places = std::vector<std::size_t>;

/// The places of a list that hold such a number.
Places places_with(const Value& value, bool (*kind)(double)) {
  Places places;
  const List* list = value.as<List>();
  for (std::size_t i = 0; list && i < list->size(); ++i)
    if (const double* x = (*list)[i].as<double>(); x && kind(*x)) places.push_back(i);
  return places;
}

/// The places of a list of numbers that differ from the demanded ones; nothing for another value.
std::optional<Places> wrong_places(const Finding& finding) {
  const List* answer = finding.answer->as<List>();
  const List* demanded = finding.demanded ? finding.demanded->as<List>() : nullptr;
  if (!answer || !demanded || answer->size() != demanded->size()) return std::nullopt;
  Places places;
  for (std::size_t i = 0; i < answer->size(); ++i) {
    const double *a = (*answer)[i].as<double>(), *d = (*demanded)[i].as<double>();
    if (!a || !d) return std::nullopt;
    if (!(std::abs(*a - *d) <= finding.tolerance)) places.push_back(i);
  }
  return places;
}

/// "Place 5", "Places 0 to 2 and 5", "Places 5, 11 and 17", "Places 5, 11, 17, …".
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
  std::string text = (places.size() == 1 ? "Place " : "Places ") + runs.front();
  for (std::size_t i = 1; i < std::min(runs.size(), most_runs); ++i)
    text += (i + 1 == runs.size() ? " and " : ", ") + runs[i];
  return text + (runs.size() > most_runs ? ", …" : "");
}

constexpr const char* look_at_the_loops =
    "Look at where your loops begin and end, and at the places that they write to.";

/// What a NaN of a new matrix means: where other numbers are right, these places were left out.
Misconception never_written(const Finding& finding) {
  const Places missing = places_with(*finding.answer, is_nan_of_new_matrix);
  const std::optional<Places> wrong = wrong_places(finding);
  if (!missing.empty() && wrong && wrong->size() < finding.answer->as<List>()->size())
    return {
        "not a number",
        text_of(missing) + " of your answer (counted from 0) " +
            (missing.size() == 1 ? "was never written, or comes" : "were never written, or come") +
            " from a vector that was not. " + look_at_the_loops,
        ""};
  return {"not a number",
          "Your answer contains NaN, of the kind that a vector or a matrix has here before it is "
          "set. Look whether each of yours begins with a value: Eigen's don't begin with zeros. "
          "(A minus before 0 / 0 can look the same.)",
          ""};
}

/// A beginning or an end of a list that is 0, where all else is right: a loop that leaves it out,
/// over a vector that began with zeros.
std::optional<Misconception> left_at_zero(const Finding& finding) {
  const std::optional<Places> wrong = wrong_places(finding);
  constexpr std::size_t of_a_loop = 6;  // fewer numbers hardly come from one
  if (!wrong || wrong->size() < 2) return std::nullopt;
  const List& answer = *finding.answer->as<List>();
  if (answer.size() < of_a_loop) return std::nullopt;
  const bool is_run = wrong->back() - wrong->front() + 1 == wrong->size(),
             is_at_an_end = wrong->front() == 0 || wrong->back() + 1 == answer.size(),
             is_zero = std::all_of(wrong->begin(), wrong->end(),
                                   [&](std::size_t i) { return *answer[i].as<double>() == 0; });
  if (!is_run || !is_at_an_end || !is_zero || count_nonzero(*finding.answer) < 2)
    return std::nullopt;
  return Misconception{"places left at zero",
                       text_of(*wrong) +
                           " of your answer (counted from 0) are 0, and all others are right. " +
                           look_at_the_loops,
                       ""};
}

/// Names of the memory that an answer comes from, and of numbers that are none.
std::vector<Misconception> names_of_content(const Finding& finding) {
  const Value& answer = *finding.answer;
  if ((contains_mark(answer) && !is_about(finding, is_huge)) ||
      (contains(answer, is_marked_float) && !is_about(finding, is_large)))
    return {
        {"never set",
         "Part of your answer comes from a variable that was never set, or that is gone: an auto "
         "may hold an expression of Eigen whose operands are. Such memory holds anything. Here it "
         "has a mark, so that it shows.",
         ""}};
  if (contains(answer, is_nan) && is_given(finding, is_nan))
    return {{"not a number", "What your function was given contains NaN, and so does your answer.",
             ""}};
  if (contains(answer, is_nan_of_new_matrix)) return {never_written(finding)};
  if (contains(answer, is_nan))
    return {
        {"not a number",
         "Your answer contains NaN: 0 was divided by 0, a root or an arc cosine was taken of what "
         "it is not defined for, or a matrix was never set or is gone. Look for a divisor that "
         "these arguments make zero.",
         ""}};
  if (contains(answer, is_infinite))
    return {{"infinite",
             "Your answer contains infinity: something is divided by 0, or grows without end.",
             ""}};
  return {};
}

/// Names of what an answer is to the right one, or to an argument.
std::vector<Misconception> names_of_likeness(const Finding& finding) {
  const Value& answer = *finding.answer;
  if (is_argument(finding))
    return {{argument_as_it_came, "Your answer is one of the arguments, unchanged.", ""}};
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

}  // namespace

bool equals_argument(const List& arguments, const Value& answer) {
  return std::any_of(arguments.begin(), arguments.end(), [&](const Value& argument) {
    return argument.as<List>() && largest_difference(argument, answer) == 0;
  });
}

std::vector<Misconception> general_misconceptions(const Finding& finding, Inputs inputs) {
  if (finding.outcome != Outcome::wrong || !finding.answer) return {};
  const std::vector<Misconception> names = names_of_content(finding);
  return names.empty() && inputs == Inputs::general ? names_of_likeness(finding) : names;
}

}  // namespace tumble::judge
