#include "judge/verdict/rounded_constant.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <regex>
#include <string>
#include <vector>

#include "judge/build/source_code.hpp"

namespace tumble::judge {

namespace {

struct Constant {
  double value;
  const char* name;
  const char* instead;
};

constexpr double pi = std::numbers::pi, root_2 = std::numbers::sqrt2;

constexpr std::array constants = {
    Constant{1. / 3, "1/3", "1.0 / 3"},
    Constant{2. / 3, "2/3", "2.0 / 3"},
    Constant{4. / 3, "4/3", "4.0 / 3"},
    Constant{1. / 6, "1/6", "1.0 / 6"},
    Constant{5. / 6, "5/6", "5.0 / 6"},
    Constant{1. / 12, "1/12", "1.0 / 12"},
    Constant{1. / 24, "1/24", "1.0 / 24"},
    Constant{1. / 60, "1/60", "1.0 / 60"},
    Constant{pi, "π", "std::numbers::pi"},
    Constant{2 * pi, "2π", "2 * std::numbers::pi"},
    Constant{pi / 2, "π/2", "std::numbers::pi / 2"},
    Constant{pi / 180, "π/180", "std::numbers::pi / 180"},
    Constant{180 / pi, "180/π", "180 / std::numbers::pi"},
    Constant{root_2, "√2", "std::sqrt(2.0)"},
    Constant{root_2 / 2, "1/√2", "std::sqrt(0.5)"},
};

/// Rounded or cut off after `decimals` digits behind the point, and not where a double ends.
bool is_written_for(double number, int decimals, double constant) {
  const double last_place = std::pow(10., -decimals), below = constant - number;
  const bool is_rounded = std::abs(below) <= last_place / 2,
             is_cut_off = below > 0 && below < last_place;
  return (is_rounded || is_cut_off) && std::abs(below) > 1e-12 * constant;
}

/// Digits that count: 3 of 0.0167.
std::size_t significant_digits(const std::string& text) {
  std::size_t count = 0;
  for (const char c : text.substr(std::min(text.find_first_of("123456789"), text.size())))
    if (c != '.') ++count;
  return count;
}

/// The constant that is meant by a number with a point. Two digits tell nothing: 0.33 may be a
/// threshold or a weight.
const Constant* meant_by(const std::string& text) {
  const std::size_t digits = significant_digits(text);
  const auto decimals = static_cast<int>(text.size() - text.find('.') - 1);
  constexpr std::size_t enough = 3;
  for (const Constant& each : constants)
    if (digits >= enough && is_written_for(std::stod(text), decimals, each.value)) return &each;
  return nullptr;
}

/// Such a number, and where its digits begin.
struct Found {
  std::size_t begin;
  std::string digits;
  const Constant* meant;
};

std::vector<Found> all_in(const std::string& code) {
  static const std::regex decimal(R"(\d{0,3}\.\d{2,18})");
  std::vector<Found> all;
  for (std::sregex_iterator at(code.begin(), code.end(), decimal), end; at != end; ++at) {
    const auto begin = static_cast<std::size_t>(at->position()),
               after = begin + static_cast<std::size_t>(at->length());
    const bool is_part = (begin > 0 && (is_of_word(code[begin - 1]) || code[begin - 1] == '.')) ||
                         (after < code.size() && is_of_word(code[after]));
    if (is_part) continue;
    if (const Constant* meant = meant_by(at->str())) all.push_back({begin, at->str(), meant});
  }
  return all;
}

/// As an operand with 17 digits: no header is needed for it.
std::string exact_text(double constant) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", constant);
  return text;
}

}  // namespace

std::optional<RoundedConstant> rounded_constant_in(const std::string& code) {
  const std::vector<Found> all = all_in(code);
  if (all.empty()) return std::nullopt;
  const Found& first = all.front();
  return RoundedConstant{first.digits, line_of(code, first.begin), first.meant->name,
                         first.meant->instead,
                         std::abs(std::stod(first.digits) / first.meant->value - 1)};
}

std::string with_exact_constants(const std::string& source) {
  const std::string code = code_of(source);
  if (code.size() != source.size()) return source;  // then places in one are none in the other
  std::string exact;
  std::size_t end = 0;
  for (const Found& each : all_in(code)) {
    exact += source.substr(end, each.begin - end) + exact_text(each.meant->value);
    end = each.begin + each.digits.size();
  }
  return exact + source.substr(end);
}

}  // namespace tumble::judge
