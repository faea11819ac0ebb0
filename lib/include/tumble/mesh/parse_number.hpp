#pragma once
/// @file
/// Decimal numbers in a text, correctly rounded, whatever the locale and the standard library.
///
/// Source: W. D. Clinger, How to read floating point numbers accurately, PLDI 1990: if the digits
/// and the power of ten are both exact as doubles, one product or quotient rounds once.

#include <cfloat>
#include <clocale>
#include <cstdint>
#include <string_view>

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

const char* parse_digits(const char* at, const char* end, Decimal& decimal);

/// Passes over e+12, if it is there and whole.
const char* parse_exponent(const char* at, const char* end, Decimal& decimal);

/// The C library's reading, freed from the locale's decimal point.
/// @param number an optional minus sign, digits with at most one point, an optional exponent
double parse_by_strtod(std::string_view number);

/// Any decimal number: by the standard library, which rounds correctly.
/// @return ∞ for what is too large, the nearest subnormal or 0 for what is small
double parse_by_library(std::string_view number);

/// Whether a product of two doubles is rounded once, to a double.
constexpr bool rounds_once = FLT_EVAL_METHOD == 0;

/// Whether one product or quotient of doubles gives the number.
bool is_exact(const Decimal& decimal);

double exact_value(const Decimal& decimal);

/// The double nearest to the decimal number at the beginning of a text: a sign, digits with or
/// without a point, an exponent. `nan`, `inf` and hexadecimal digits are not numbers.
/// @return ∞ for a number too large for a double
Parsed<double> parse_double(const char* begin, const char* end);

/// The integer at the beginning of a text: a sign and digits.
/// @return a value beyond ± 10¹⁷ for any integer that is
Parsed<std::int64_t> parse_integer(const char* begin, const char* end);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/parse_number.inl"
#endif
