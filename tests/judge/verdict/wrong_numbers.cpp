#include "judge/verdict/wrong_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "judge/spec/places.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::judge {

namespace {

using MaybeName = std::optional<Misconception>;

/// An answer beside the demanded one, number by number. At least one number is wrong.
struct Compared {
  const Value& value;  ///< the answer
  std::vector<double> answer, demanded;
  Places wrong;
  double tolerance;

  std::size_t right() const { return answer.size() - wrong.size(); }
  /// " of your answer (counted from 0)": where they stand, if places have numbers.
  std::string where() const {
    const bool is_counted = is_vector(value) || (is_square_matrix(value) && wrong.size() <= 2);
    return is_counted ? " of your answer (counted from 0)" : " of your answer";
  }
  /// ", and all others are right"; nothing if there are no others.
  std::string but_the_others() const { return right() > 0 ? ", and all others are right" : ""; }
};

std::optional<Compared> compared(const Finding& finding) {
  std::optional<Places> wrong = wrong_places(finding);
  if (!wrong || wrong->empty()) return std::nullopt;
  return Compared{*finding.answer, *numbers_in(*finding.answer), *numbers_in(*finding.demanded),
                  std::move(*wrong), finding.tolerance};
}

/// What all wrong numbers are divided by the right ones; nothing if it is not the same of all.
std::optional<double> ratio_of_wrong(const Compared& each) {
  const std::size_t largest =
      *std::max_element(each.wrong.begin(), each.wrong.end(), [&](std::size_t i, std::size_t j) {
        return std::abs(each.demanded[i]) < std::abs(each.demanded[j]);
      });
  const double ratio = each.answer[largest] / each.demanded[largest];
  if (!std::isfinite(ratio)) return std::nullopt;
  const bool is_the_same = std::all_of(each.wrong.begin(), each.wrong.end(), [&](std::size_t i) {
    const double rounding = 64 * detail::unit_roundoff * std::abs(each.answer[i]);
    return std::abs(each.answer[i] - ratio * each.demanded[i]) <=
           2 * (1 + std::abs(ratio)) * each.tolerance + rounding;
  });
  if (!is_the_same) return std::nullopt;
  return ratio;
}

/// Right numbers that are not 0: what speaks for the rest of the student's code.
std::size_t right_and_nonzero(const Compared& each) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < each.demanded.size(); ++i)
    if (each.demanded[i] != 0 && !std::binary_search(each.wrong.begin(), each.wrong.end(), i))
      ++count;
  return count;
}

MaybeName signs_wrong(const Compared& each) {
  const std::optional<double> ratio = ratio_of_wrong(each);
  if (!ratio || std::abs(*ratio + 1) > 1e-9 || right_and_nonzero(each) == 0) return std::nullopt;
  return Misconception{"some signs wrong",
                       capitalised(text_of(each.wrong, each.value)) + each.where() +
                           (each.wrong.size() == 1 ? " has" : " have") +
                           " the wrong sign, and all others are right. Look at each minus and at "
                           "the order of each difference.",
                       ""};
}

MaybeName one_number_wrong(const Compared& each) {
  if (each.wrong.size() != 1 || right_and_nonzero(each) < 2) return std::nullopt;
  return Misconception{"one number wrong",
                       "Only " + text_of(each.wrong, each.value) + each.where() +
                           " is wrong. Compare the line that computes it with those of the others, "
                           "term by term.",
                       ""};
}

std::string short_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

MaybeName off_by_a_factor(const Compared& each) {
  const std::optional<double> ratio = ratio_of_wrong(each);
  std::size_t nonzero = 0;
  for (const std::size_t i : each.wrong) nonzero += each.demanded[i] != 0 ? 1u : 0u;
  const bool is_factor = ratio && nonzero >= 2 && std::abs(*ratio) > 1e-12;
  if (!is_factor || std::abs(std::abs(*ratio) - 1) < 1e-5) return std::nullopt;
  const std::string who =
      each.right() > 0 ? capitalised(text_of(each.wrong, each.value)) + each.where() + " are each "
                       : "Each number of your answer is ";
  return Misconception{"off by a factor",
                       who + short_text(*ratio) + " times what is demanded" +
                           each.but_the_others() +
                           ". Look for a factor that is missing, or one too many.",
                       ""};
}

/// The right numbers, some of them at each other's places.
MaybeName at_wrong_places(const Compared& each) {
  std::vector<double> here, there;
  for (const std::size_t i : each.wrong) {
    here.push_back(each.answer[i]);
    there.push_back(each.demanded[i]);
  }
  const double sought = here.front();
  std::sort(here.begin(), here.end());
  std::sort(there.begin(), there.end());
  const auto is_near = [&](double a, double b) { return std::abs(a - b) <= each.tolerance; };
  if (here.size() < 2 || !std::equal(here.begin(), here.end(), there.begin(), is_near))
    return std::nullopt;
  const bool is_one_of_two = std::adjacent_find(there.begin(), there.end(), is_near) != there.end();
  if (is_one_of_two || !is_vector(each.value))
    return Misconception{"numbers at wrong places",
                         "Your answer has the right numbers, but some of them stand at each "
                         "other's places.",
                         ""};
  const auto own = std::find_if(each.wrong.begin(), each.wrong.end(),
                                [&](std::size_t i) { return is_near(each.demanded[i], sought); });
  return Misconception{"numbers at wrong places",
                       "Your answer has the right numbers, but not at their places: the number at "
                       "place " +
                           std::to_string(each.wrong.front()) + " (counted from 0) belongs to " +
                           "place " + std::to_string(*own) + ".",
                       ""};
}

/// All wrong numbers of a matrix stand in one row, or in one column.
MaybeName line_wrong(const Compared& each) {
  if (!is_square_matrix(each.value) || each.wrong.size() < 2 || right_and_nonzero(each) < 2)
    return std::nullopt;
  const std::size_t size = each.value.as<List>()->size(), first = each.wrong.front();
  const auto all_share = [&](auto line) {
    return std::all_of(each.wrong.begin(), each.wrong.end(),
                       [&](std::size_t i) { return line(i) == line(first); });
  };
  const auto name = [&](const std::string& kind, std::size_t number) {
    return Misconception{"one " + kind + " wrong",
                         "Only " + kind + " " + std::to_string(number) +
                             " of your matrix (counted from 0) is wrong.",
                         ""};
  };
  if (all_share([&](std::size_t i) { return i / size; })) return name("row", first / size);
  if (all_share([&](std::size_t i) { return i % size; })) return name("column", first % size);
  return std::nullopt;
}

/// A part of a long list, of which nothing else is seen: what all particles have in common, say.
MaybeName some_wrong(const Compared& each) {
  constexpr std::size_t of_a_loop = 6;  // fewer numbers are read at a glance
  const std::size_t size = each.answer.size();
  if (!is_vector(each.value) || size < of_a_loop || 2 * each.wrong.size() > size ||
      right_and_nonzero(each) < size / 2)
    return std::nullopt;
  return Misconception{"some numbers wrong",
                       capitalised(text_of(each.wrong)) +
                           " of your answer (counted from 0) are wrong, and all others are right.",
                       ""};
}

}  // namespace

void name_wrong_numbers(Finding& finding) {
  const bool is_explained = !finding.misconceptions.empty() || !finding.place.empty();
  if (finding.outcome != Outcome::wrong || is_explained) return;
  const std::optional<Compared> both = compared(finding);
  if (!both) return;
  for (const auto& look :
       {signs_wrong, one_number_wrong, off_by_a_factor, at_wrong_places, line_wrong, some_wrong})
    if (const MaybeName name = look(*both)) {
      finding.misconceptions = {*name};
      return;
    }
}

}  // namespace tumble::judge
