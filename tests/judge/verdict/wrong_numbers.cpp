#include "judge/verdict/wrong_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "judge/spec/demand.hpp"
#include "judge/spec/likeness.hpp"
#include "judge/spec/places.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::judge {

namespace {

using MaybeName = std::optional<Misconception>;

/// How many numbers a part of an answer has.
std::size_t count_of(const Value& part) {
  const auto numbers = numbers_in(part);
  return numbers ? numbers->size() : 0;
}

/// Which numbers of a struct are wrong: "ab and bb", "one number in centre".
std::vector<std::string> wrong_members(const Value& value, const std::vector<std::string>& members,
                                       const Places& wrong) {
  std::vector<std::string> texts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::size_t size = count_of((*value.as<List>())[i]);
    const auto first = std::lower_bound(wrong.begin(), wrong.end(), begin),
               last = std::lower_bound(wrong.begin(), wrong.end(), begin + size);
    const auto count = static_cast<std::size_t>(last - first);
    if (count == size && count > 0)
      texts.push_back(members[i]);
    else if (count > 0)
      texts.push_back((count == 1 ? "one number" : std::to_string(count) + " numbers") + " in " +
                      members[i]);
    begin += size;
  }
  return texts;
}

/// "ab", "ab and bb", "ab, bb and cc".
std::string joined(const std::vector<std::string>& texts) {
  std::string text = texts.front();
  for (std::size_t i = 1; i < texts.size(); ++i)
    text += (i + 1 == texts.size() ? " and " : ", ") + texts[i];
  return text;
}

/// An answer beside the demanded one, number by number. At least one number is wrong.
struct Compared {
  const Value& value;  ///< the answer
  std::vector<double> answer, demanded;
  Places wrong;
  double tolerance;
  std::vector<std::string> members;  ///< of a struct; empty if it is none

  bool is_struct() const { return !members.empty(); }
  std::size_t right() const { return answer.size() - wrong.size(); }
  bool is_of_a_loop() const { return !is_struct() && answer.size() >= of_a_loop; }

  /// What is wrong: "place 5 of your answer (counted from 0)", "ab and bb of your answer".
  std::string which() const {
    constexpr std::size_t most_of_a_matrix = 2;
    if (is_struct()) return which_members() + " of your answer";
    const bool is_counted = is_vector(value) || wrong.size() <= most_of_a_matrix;
    return text_of(wrong, value) + " of your answer" + (is_counted ? " (counted from 0)" : "");
  }
  std::string which_members() const {
    constexpr std::size_t most = 3;
    const std::vector<std::string> texts = wrong_members(value, members, wrong);
    return texts.size() <= most ? joined(texts) : std::to_string(wrong.size()) + " numbers";
  }
  /// The same to begin a sentence. A member's name keeps its small letter.
  std::string capital_which() const {
    return is_struct() ? "In your answer, " + which_members() : capitalised(which());
  }
  /// Whether "has" follows it, not "have".
  bool is_one() const {
    if (!is_struct() || wrong.size() == 1) return wrong.size() == 1;
    const std::string text = which_members();
    return std::find(members.begin(), members.end(), text) != members.end();
  }
  /// ", and all others are right"; nothing if there are no others.
  std::string but_the_others() const { return right() > 0 ? ", and all others are right" : ""; }
};

/// Whether an answer is off by so much that neither rounding nor too few steps are the reason.
bool is_far_off(const Finding& finding) {
  const double apart = largest_difference(*finding.answer, *finding.demanded);
  return apart > 1e-9 * largest_magnitude(*finding.demanded) && apart > 1000 * finding.tolerance;
}

/// Whether an answer can be told of by its places, or by the members of a struct.
bool has_places(const Value& answer, const AnswerType& type) {
  if (type.is_plain()) return is_vector(answer) || is_square_matrix(answer);
  const List* parts = answer.as<List>();
  return parts && !type.members.empty() && parts->size() == type.members.size();
}

std::optional<Compared> compared(const Finding& finding, const AnswerType& type) {
  std::optional<Places> wrong = wrong_places(finding);
  if (!wrong || wrong->empty() || !is_far_off(finding) || !has_places(*finding.answer, type))
    return std::nullopt;
  return Compared{*finding.answer,
                  *numbers_in(*finding.answer),
                  *numbers_in(*finding.demanded),
                  std::move(*wrong),
                  finding.tolerance,
                  type.members};
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

/// What to look at behind wrong signs. Several numbers of which none is negative any more have
/// likely lost their signs together.
std::string advice_on_signs(const Compared& each) {
  const bool has_no_negative = std::all_of(each.wrong.begin(), each.wrong.end(),
                                           [&](std::size_t i) { return each.answer[i] > 0; });
  if (has_no_negative && each.wrong.size() > 1)
    return "Have you taken an absolute value or a square?";
  return "Look at each minus and at the order of each difference.";
}

MaybeName wrong_signs(const Compared& each) {
  const std::optional<double> ratio = ratio_of_wrong(each);
  if (!ratio || std::abs(*ratio + 1) > 1e-9 || right_and_nonzero(each) == 0) return std::nullopt;
  return Misconception{"some wrong signs",
                       each.capital_which() + (each.is_one() ? " has" : " have") +
                           " the wrong sign, and all others are right. " + advice_on_signs(each),
                       ""};
}

MaybeName one_wrong_number(const Compared& each) {
  if (each.wrong.size() != 1 || right_and_nonzero(each) < 2) return std::nullopt;
  return Misconception{
      "one wrong number",
      "Only " + each.which() +
          (each.is_of_a_loop() ? " is wrong. Compare the line that computes it with those of the "
                                 "others, term by term."
                               : " is wrong; all others are right."),
      ""};
}

/// Whether a number is p/q with small p and q. A factor that somebody forgets is one.
bool is_short_fraction(double x) {
  constexpr int most = 12;
  for (int below = 1; below <= most; ++below) {
    const double above = std::round(x * below);
    if (above >= 1 && above <= most && std::abs(x * below - above) <= 1e-9 * above) return true;
  }
  return false;
}

/// Whether a factor is one that is forgotten or written twice: 2, 1/6, π/2, √2.
bool is_usual_factor(double ratio) {
  constexpr double pi = std::numbers::pi, root_2 = std::numbers::sqrt2;
  const double size = std::abs(ratio);
  const bool is_only_a_sign = std::abs(size - 1) < 1e-9;
  return !is_only_a_sign && (is_short_fraction(size) || is_short_fraction(size / pi) ||
                             is_short_fraction(size * pi) || is_short_fraction(size / root_2));
}

std::string ratio_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

MaybeName wrong_factor(const Compared& each) {
  const std::optional<double> ratio = ratio_of_wrong(each);
  std::size_t nonzero = 0;
  for (const std::size_t i : each.wrong) nonzero += each.demanded[i] != 0 ? 1u : 0u;
  const bool is_factor = ratio && nonzero >= 2 && std::abs(*ratio) > 1e-12;
  if (!is_factor || std::abs(std::abs(*ratio) - 1) < 1e-3) return std::nullopt;
  const std::string who = each.right() > 0
                              ? each.capital_which() + (each.is_one() ? " is " : " are each ")
                              : "Each number of your answer is ";
  return Misconception{
      "a wrong factor",
      who + ratio_text(*ratio) + " times the demanded one" + each.but_the_others() + "." +
          (is_usual_factor(*ratio) ? " Look for a factor that is missing, or one too many." : ""),
      ""};
}

/// The right numbers, some of them in each other's places.
MaybeName in_wrong_places(const Compared& each) {
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
  if (is_one_of_two || each.is_struct() || !is_vector(each.value))
    return Misconception{"numbers in the wrong places",
                         "Your answer has the right numbers, but some of them have changed "
                         "places.",
                         ""};
  const auto own = std::find_if(each.wrong.begin(), each.wrong.end(),
                                [&](std::size_t i) { return is_near(each.demanded[i], sought); });
  return Misconception{"numbers in the wrong places",
                       "Your answer has the right numbers, but not in their places: the number at "
                       "place " +
                           std::to_string(each.wrong.front()) + " (counted from 0) belongs to " +
                           "place " + std::to_string(*own) + ".",
                       ""};
}

/// All wrong numbers of a matrix are in one row, or in one column.
MaybeName wrong_line(const Compared& each) {
  if (each.is_struct() || !is_square_matrix(each.value) || each.wrong.size() < 2 ||
      right_and_nonzero(each) < 2)
    return std::nullopt;
  const std::size_t size = each.value.as<List>()->size(), first = each.wrong.front();
  const auto all_share = [&](auto line) {
    return std::all_of(each.wrong.begin(), each.wrong.end(),
                       [&](std::size_t i) { return line(i) == line(first); });
  };
  const auto name = [&](const std::string& kind, std::size_t number) {
    return Misconception{"one wrong " + kind,
                         "Only " + kind + " " + std::to_string(number) +
                             " of your matrix (counted from 0) is wrong.",
                         ""};
  };
  if (all_share([&](std::size_t i) { return i / size; })) return name("row", first / size);
  if (all_share([&](std::size_t i) { return i % size; })) return name("column", first % size);
  return std::nullopt;
}

/// A part of a long list, of which nothing else is seen: what all particles have in common, say.
MaybeName some_wrong_numbers(const Compared& each) {
  const std::size_t size = each.answer.size();
  if (!is_vector(each.value) || size < of_a_loop || 2 * each.wrong.size() > size ||
      right_and_nonzero(each) < size / 2)
    return std::nullopt;
  return Misconception{
      "some wrong numbers",
      each.capital_which() + (each.is_one() ? " is" : " are") + " wrong, and all others are right.",
      ""};
}

}  // namespace

void name_wrong_numbers(Finding& finding, const AnswerType& type) {
  const bool is_explained = !finding.misconceptions.empty() || !finding.place.empty();
  if (finding.outcome != Outcome::wrong || is_explained) return;
  const std::optional<Compared> both = compared(finding, type);
  if (!both) return;
  for (const auto& look : {wrong_signs, one_wrong_number, wrong_factor, in_wrong_places, wrong_line,
                           some_wrong_numbers})
    if (const MaybeName name = look(*both)) {
      finding.misconceptions = {*name};
      return;
    }
}

void drop_places(Finding& finding) {
  std::erase_if(finding.misconceptions,
                [](const Misconception& each) { return each.name == left_at_zero_name; });
}

}  // namespace tumble::judge
