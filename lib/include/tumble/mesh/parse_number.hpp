#pragma once
/// @file
/// Decimal numbers in a text, correctly rounded, whatever the locale and the standard library.
///
/// Source: W. D. Clinger, How to read floating point numbers accurately, PLDI 1990: if the digits
/// and the power of ten are both exact as doubles, one product or quotient rounds once.

#include <array>
#include <cfloat>
#include <charconv>
#include <clocale>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace tumble::detail {

/// A number at the beginning of a text.
template <class T>
struct Parsed {
  T value;
  const char*
      end;  ///< the first character that does not belong to it; the beginning if there is none
};

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The digits and the power of ten of a decimal number: value = digits · 10^exponent.
struct Decimal {
  std::uint64_t digits = 0;  ///< right up to digit_count = 19
  int digit_count = 0;       ///< with zeros in front
  int exponent = 0;          ///< right up to ± 10⁵, and then large
};

inline const char* parse_digits(const char* at, const char* end, Decimal& decimal) {
  const char* const begin = at;
  std::uint64_t digits = decimal.digits;
  for (; at != end && is_digit(*at); ++at)
    digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
  decimal.digits = digits;
  // More than a thousand are too many anyway: the count must not overflow.
  decimal.digit_count += static_cast<int>(at - begin < 1000 ? at - begin : 1000);
  return at;
}

/// Passes over e+12, if it is there and whole.
inline const char* parse_exponent(const char* at, const char* end, Decimal& decimal) {
  if (at == end || (*at != 'e' && *at != 'E')) return at;
  const char* const sign = at + 1;
  const bool has_sign = sign != end && (*sign == '-' || *sign == '+');
  const char* digit = has_sign ? sign + 1 : sign;
  if (digit == end || !is_digit(*digit)) return at;
  int exponent = 0;
  for (; digit != end && is_digit(*digit); ++digit)
    if (exponent < 100'000) exponent = 10 * exponent + (*digit - '0');
  decimal.exponent += has_sign && *sign == '-' ? -exponent : exponent;
  return digit;
}

/// The C library's reading, freed from the locale's decimal point.
/// @param number an optional minus sign, digits with at most one point, an optional exponent
inline double parse_by_strtod(std::string_view number) {
  std::string text(number);
  const std::size_t point = text.find('.');
  if (point != std::string::npos) text.replace(point, 1, std::localeconv()->decimal_point);
  return std::strtod(text.c_str(), nullptr);
}

/// Any decimal number: by the standard library, which rounds correctly.
/// @return ∞ for what is too large, the nearest subnormal or 0 for what is small
inline double parse_by_library(std::string_view number) {
#if defined(__cpp_lib_to_chars)
  double value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error == std::errc()) return value;  // else too large or too small
#endif
  return parse_by_strtod(number);
}

/// Whether a product of two doubles is rounded once, to a double.
constexpr bool rounds_once = FLT_EVAL_METHOD == 0;

/// Whether one product or quotient of doubles gives the number.
inline bool is_exact(const Decimal& decimal) {
  constexpr std::uint64_t largest = std::uint64_t{1} << 53;
  return rounds_once && decimal.digit_count <= 19 && decimal.digits <= largest &&
         decimal.exponent >= -22 && decimal.exponent <= 22;
}

inline double exact_value(const Decimal& decimal) {
  constexpr std::array<double, 23> power = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                            1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const auto digits = static_cast<double>(decimal.digits);
  return decimal.exponent < 0 ? digits / power[static_cast<std::size_t>(-decimal.exponent)]
                              : digits * power[static_cast<std::size_t>(decimal.exponent)];
}

/// The double nearest to the decimal number at the beginning of a text: a sign, digits with or
/// without a point, an exponent. `nan`, `inf` and hexadecimal digits are not numbers.
/// @return ∞ for a number too large for a double
inline Parsed<double> parse_double(const char* const begin, const char* const end) {
  const bool negative = begin != end && *begin == '-';
  const bool has_sign = negative || (begin != end && *begin == '+');
  const char* const first = has_sign ? begin + 1 : begin;
  Decimal decimal;
  const char* at = parse_digits(first, end, decimal);
  if (at != end && *at == '.') {
    const char* const fraction = at + 1;
    at = parse_digits(fraction, end, decimal);
    decimal.exponent = -static_cast<int>(at - fraction < 1000 ? at - fraction : 1000);
  }
  if (decimal.digit_count == 0) return {0, begin};
  at = parse_exponent(at, end, decimal);
  const double value = is_exact(decimal)
                           ? exact_value(decimal)
                           : parse_by_library({first, static_cast<std::size_t>(at - first)});
  return {negative ? -value : value, at};
}

/// The integer at the beginning of a text: a sign and digits.
/// @return a value beyond ± 10¹⁷ for any integer that is
inline Parsed<std::int64_t> parse_integer(const char* const begin, const char* const end) {
  const bool negative = begin != end && *begin == '-';
  const bool has_sign = negative || (begin != end && *begin == '+');
  const char* const first = has_sign ? begin + 1 : begin;
  std::int64_t value = 0;
  const char* at = first;
  for (; at != end && is_digit(*at); ++at)
    if (value <= 100'000'000'000'000'000) value = 10 * value + (*at - '0');
  if (at == first) return {0, begin};
  return {negative ? -value : value, at};
}

}  // namespace tumble::detail
