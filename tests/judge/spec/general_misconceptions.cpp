#include "judge/spec/general_misconceptions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include "judge/spec/likeness.hpp"
#include "judge/spec/places.hpp"

namespace tumble::judge {

namespace {

bool contains(const Value& value, bool (*kind)(double)) {
  if (const double* x = value.as<double>()) return kind(*x);
  const List* list = value.as<List>();
  return list && std::any_of(list->begin(), list->end(),
                             [&](const Value& each) { return contains(each, kind); });
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

/// The places of a list that hold such a number.
Places places_with(const Value& value, bool (*kind)(double)) {
  Places places;
  const List* list = value.as<List>();
  for (std::size_t i = 0; list && i < list->size(); ++i)
    if (const double* x = (*list)[i].as<double>(); x && kind(*x)) places.push_back(i);
  return places;
}

/// What a NaN of a new matrix means: where other numbers are right, these places were left out.
Misconception never_written(const Finding& finding) {
  const Places missing = places_with(*finding.answer, is_nan_of_new_matrix);
  const std::optional<Places> wrong = wrong_places(finding);
  if (!missing.empty() && wrong && wrong->size() < finding.answer->as<List>()->size())
    return {
        "not a number",
        capitalised(text_of(missing)) + " of your answer (counted from 0) " +
            (missing.size() == 1 ? "was never written, or comes" : "were never written, or come") +
            " from a vector that was not. " + look_at_the_loops,
        ""};
  return {"not a number",
          "Your answer contains NaN, of the kind that a vector or a matrix has here before it is "
          "set. Look whether each of yours begins with a value: Eigen's don't begin with zeros. "
          "(A minus before 0 / 0 can look the same.)",
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

}  // namespace

std::vector<Misconception> general_misconceptions(const Finding& finding, Inputs inputs) {
  if (finding.outcome != Outcome::wrong || !finding.answer) return {};
  const std::vector<Misconception> names = names_of_content(finding);
  return names.empty() && inputs == Inputs::general ? names_of_likeness(finding) : names;
}

}  // namespace tumble::judge
