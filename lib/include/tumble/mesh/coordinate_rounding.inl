#pragma once

#include "tumble/mesh/coordinate_rounding.hpp"

#include <limits>
#include <set>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY double power_of_ten(int n) {
  double power = 1;
  for (int i = 0; i < std::abs(n); ++i) power *= 10;
  return n < 0 ? 1 / power : power;
}

TUMBLE_BODY bool is_decimal(double x, int places) {
  constexpr double whole = 0x1p53;  // above it all doubles are
  const double power = power_of_ten(std::abs(places));
  const double scaled = std::nearbyint(places >= 0 ? x * power : x / power);
  return std::abs(scaled) < whole && (places >= 0 ? scaled / power : scaled * power) == x;
}

TUMBLE_BODY bool many_need_last(const WrittenDigits& digits, bool fixed,
                                std::span<const Vec3> vertices) {
  constexpr std::size_t many = 12;
  std::set<double> numbers;
  for (const Vec3& p : vertices)
    for (const double x : p) {
      if (x != 0 && !is_decimal(x, digits.last_place(first_place(x), fixed) - 1))
        numbers.insert(std::abs(x));
      if (numbers.size() >= many) return true;
    }
  return false;
}

TUMBLE_BODY double half_gap(double x) {
  return std::ldexp(1.0, std::ilogb(x) - std::numeric_limits<float>::digits);
}

TUMBLE_BODY bool needs_last_bits(float x) {
  constexpr int last = 2;
  int exponent = 0;
  const float bits =
      std::ldexp(std::frexp(x, &exponent), std::numeric_limits<float>::digits - last);
  return bits != std::floor(bits);
}

TUMBLE_BODY bool many_need_last_bits(const WrittenDigits& digits, bool fixed,
                                     std::span<const Vec3> vertices) {
  constexpr std::size_t many = 12;
  std::set<double> numbers;
  for (const Vec3& p : vertices)
    for (const double x : p)
      if (x != 0) numbers.insert(std::abs(x));
  const auto need =
      static_cast<std::size_t>(std::count_if(numbers.begin(), numbers.end(), [&](double x) {
        return needs_last_bits(static_cast<float>(x)) &&
               half_gap(x) > digits.rounding(first_place(x), fixed);
      }));
  return need >= many && 2 * need >= numbers.size();
}

TUMBLE_BODY bool is_long_float(const WrittenDigits& digits, std::span<const Vec3> vertices) {
  constexpr int dozen = 12;  // a float at 10⁵ has as many: it is a multiple of 1/128
  if (digits.significant < dozen) return false;
  return std::any_of(vertices.begin(), vertices.end(), [](const Vec3& p) {
    return std::any_of(p.begin(), p.end(), [](double x) {
      return needs_last_bits(static_cast<float>(x)) && !is_decimal(x, dozen - 2 - first_place(x));
    });
  });
}

TUMBLE_BODY double rounding_of_floats(const WrittenDigits& digits, bool fixed,
                                      std::span<const Vec3> vertices) {
  constexpr double half = 1.05;  // a float may be half-way between two decimals, and rounded
  double largest = 0;
  for (const Vec3& p : vertices)
    for (const double x : p) {
      const auto as_float = static_cast<float>(x);
      if (x == 0) continue;
      const double moved = std::abs(x - double{as_float});
      if (!(moved <= half * digits.rounding(first_place(x), fixed))) return 0;
      largest = std::max(largest, std::abs(x));
    }
  if (!is_long_float(digits, vertices) && !many_need_last_bits(digits, fixed, vertices)) return 0;
  return half_gap(largest);
}

TUMBLE_BODY double rounding_of_floats(const WrittenDigits& digits, std::span<const Vec3> vertices) {
  // `%f` or `%g`: with few numbers we cannot tell which, so we try both.
  return std::max(rounding_of_floats(digits, true, vertices),
                  rounding_of_floats(digits, false, vertices));
}

TUMBLE_BODY WrittenDigits written_digits(std::span<const Vec3> vertices) {
  WrittenDigits digits;
  for (const Vec3& p : vertices)
    for (const double x : p) digits.add(x);
  return digits;
}

TUMBLE_BODY bool may_be_chosen(std::span<const Vec3> vertices) {
  const WrittenDigits digits = written_digits(vertices);
  return !many_need_last(digits, true, vertices) && !many_need_last(digits, false, vertices) &&
         rounding_of_floats(digits, vertices) == 0;
}

TUMBLE_BODY double coordinate_rounding(std::span<const Vec3> vertices) {
  constexpr int fewest = 6, least = 3;
  const WrittenDigits digits = written_digits(vertices);
  const auto many = [&](bool fixed) { return many_need_last(digits, fixed, vertices); };
  const bool fixed = digits.may_be_fixed() && (many(true) || !many(false));
  const bool rounded = digits.significant >= fewest || (digits.significant >= least && many(fixed));
  return rounded ? std::max(digits.rounding(digits.largest_place, fixed),
                            rounding_of_floats(digits, vertices))
                 : 0;
}

}  // namespace tumble::detail
