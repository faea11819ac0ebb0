#pragma once

#include "tumble/mesh/parse_number.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <string>
#include <system_error>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY const char* parse_digits(const char* at, const char* end, Decimal& decimal) {
  const char* const begin = at;
  std::uint64_t digits = decimal.digits;
  for (; at != end && is_digit(*at); ++at)
    digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
  decimal.digits = digits;
  // More than a thousand are too many anyway: the count must not overflow.
  decimal.digit_count += static_cast<int>(at - begin < 1000 ? at - begin : 1000);
  return at;
}

TUMBLE_BODY const char* parse_exponent(const char* at, const char* end, Decimal& decimal) {
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

TUMBLE_BODY double parse_by_strtod(std::string_view number) {
  std::string text(number);
  const std::size_t point = text.find('.');
  if (point != std::string::npos) text.replace(point, 1, std::localeconv()->decimal_point);
  return std::strtod(text.c_str(), nullptr);
}

TUMBLE_BODY double parse_by_library(std::string_view number) {
#if defined(__cpp_lib_to_chars)
  double value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error == std::errc()) return value;  // else too large or too small
#endif
  return parse_by_strtod(number);
}

TUMBLE_BODY bool is_exact(const Decimal& decimal) {
  constexpr std::uint64_t largest = std::uint64_t{1} << 53;
  return rounds_once && decimal.digit_count <= 19 && decimal.digits <= largest &&
         decimal.exponent >= -22 && decimal.exponent <= 22;
}

TUMBLE_BODY double exact_value(const Decimal& decimal) {
  constexpr std::array<double, 23> power = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                            1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const auto digits = static_cast<double>(decimal.digits);
  return decimal.exponent < 0 ? digits / power[static_cast<std::size_t>(-decimal.exponent)]
                              : digits * power[static_cast<std::size_t>(decimal.exponent)];
}

TUMBLE_BODY Parsed<double> parse_double(const char* const begin, const char* const end) {
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

TUMBLE_BODY Parsed<std::int64_t> parse_integer(const char* const begin, const char* const end) {
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
