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

TUMBLE_BODY bool needs_many_bits(float x) {
  constexpr int many = 20;
  int exponent = 0;
  const float bits = std::ldexp(std::frexp(x, &exponent), many);
  return bits != std::floor(bits);
}

TUMBLE_BODY double rounding_of_floats(const WrittenDigits& digits, bool fixed,
                                      std::span<const Vec3> vertices) {
  constexpr double half = 1.05;  // a float may be half-way between two decimals, and rounded
  double largest = 0;
  bool needs_floats = false;
  for (const Vec3& p : vertices)
    for (const double x : p) {
      const auto as_float = static_cast<float>(x);
      if (x == 0) continue;
      const double moved = std::abs(x - double{as_float});
      if (!(moved <= half * digits.rounding(first_place(x), fixed))) return 0;
      needs_floats = needs_floats || needs_many_bits(as_float);
      largest = std::max(largest, std::abs(x));
    }
  return needs_floats ? std::ldexp(1.0, std::ilogb(largest) - std::numeric_limits<float>::digits)
                      : 0;
}

TUMBLE_BODY double coordinate_rounding(std::span<const Vec3> vertices) {
  constexpr int fewest = 6, least = 3;
  WrittenDigits digits;
  for (const Vec3& p : vertices)
    for (const double x : p) digits.add(x);
  const auto many = [&](bool fixed) { return many_need_last(digits, fixed, vertices); };
  const bool fixed = digits.may_be_fixed() && (many(true) || !many(false));
  const bool rounded = digits.significant >= fewest || (digits.significant >= least && many(fixed));
  // As floats they are of one kind or the other: a few may look as if they were of both.
  return rounded ? std::max({digits.rounding(digits.largest_place, fixed),
                             rounding_of_floats(digits, true, vertices),
                             rounding_of_floats(digits, false, vertices)})
                 : 0;
}

}  // namespace tumble::detail
