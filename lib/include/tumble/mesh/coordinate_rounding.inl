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

TUMBLE_BODY double rounding_of_floats(std::span<const Vec3> vertices) {
  constexpr int digits = std::numeric_limits<float>::digits;
  double largest = 0;
  for (const Vec3& p : vertices)
    for (const double x : p) {
      if (static_cast<double>(static_cast<float>(x)) != x) return 0;
      largest = std::max(largest, std::abs(x));
    }
  return largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - digits) : 0;
}

TUMBLE_BODY double coordinate_rounding(std::span<const Vec3> vertices) {
  constexpr int fewest = 6, least = 3;
  WrittenDigits digits;
  for (const Vec3& p : vertices)
    for (const double x : p) digits.add(x);
  if (digits.significant >= WrittenDigits::most) return rounding_of_floats(vertices);
  const auto many = [&](bool fixed) { return many_need_last(digits, fixed, vertices); };
  const bool fixed = digits.may_be_fixed() && (many(true) || !many(false));
  const bool rounded = digits.significant >= fewest || (digits.significant >= least && many(fixed));
  return rounded ? power_of_ten(-digits.last_place(digits.largest_place, fixed)) / 2 : 0;
}

}  // namespace tumble::detail
