#pragma once
/// @file
/// How coarsely the coordinates of a mesh were written: half a unit of a file's last decimal is
/// rounding, not shape.
///
/// A file says `0.123457`; the double that is read is the nearest one to it, and of all decimals
/// with so few digits it is the nearest to one only. So the digits can be counted afterwards.

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {

/// 10^n, rounded once for |n| ≤ 22.
inline double power_of_ten(int n) {
  double power = 1;
  for (int i = 0; i < std::abs(n); ++i) power *= 10;
  return n < 0 ? 1 / power : power;
}

/// The power of ten of the first digit of x ≠ 0: 0 for 1.5.
inline int first_place(double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); }

/// Whether x is the double nearest to a decimal number whose last digit stands at 10^−places.
inline bool is_decimal(double x, int places) {
  constexpr double whole = 0x1p53;  // above it all doubles are
  const double power = power_of_ten(std::abs(places));
  const double scaled = std::nearbyint(places >= 0 ? x * power : x / power);
  return std::abs(scaled) < whole && (places >= 0 ? scaled / power : scaled * power) == x;
}

/// Decimals that all coordinates of a mesh are written with.
struct WrittenDigits {
  int places = -20;          ///< behind the point, the most of any
  int significant = 0;       ///< from the first digit on, the most of any
  int largest_place = -400;  ///< the power of ten of the largest coordinate's first digit

  static constexpr int most = 16;  ///< with so many, a decimal is a double like any other

  void add(double x) {
    if (x == 0 || significant >= most) return;
    const int first = first_place(x);
    largest_place = std::max(largest_place, first);
    int last = std::max(1, significant) - 1 - first;  // place of the last digit
    // Beside coordinates that are 10²² times as large, this one says nothing.
    while (last <= 22 && last + first < most && !is_decimal(x, last)) ++last;
    if (last > 22) return;
    significant = std::max(significant, last + first + 1);
    while (last > places && is_decimal(x, last - 1)) --last;
    places = std::max(places, last);
  }

  /// Whether there may be so many places, as in `%.6f`. If there are so many digits, as in `%g`,
  /// small coordinates have more places.
  bool may_be_fixed() const { return places <= significant - largest_place; }

  /// Where the last digit stands of a number that begins at 10^first.
  int last_place(int first, bool fixed) const { return fixed ? places : significant - 1 - first; }
};

/// Whether many different numbers need the last digit: one may have been chosen so, and of many
/// numbers that were rounded nine in ten do.
inline bool many_need_last(const WrittenDigits& digits, bool fixed,
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

/// Half of what lies between floats at the largest coordinate, if all are floats; else 0.
inline double rounding_of_floats(std::span<const Vec3> vertices) {
  constexpr int digits = std::numeric_limits<float>::digits;
  double largest = 0;
  for (const Vec3& p : vertices)
    for (const double x : p) {
      if (static_cast<double>(static_cast<float>(x)) != x) return 0;
      largest = std::max(largest, std::abs(x));
    }
  return largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - digits) : 0;
}

/// How far a coordinate may be from what it was before it was written: half a unit of the last
/// decimal, or of the last bit of a float [m]; 0 if the coordinates are doubles like any others, or
/// were chosen with so few digits (less than six, and not many with the last) that they may well be
/// exact.
inline double coordinate_rounding(std::span<const Vec3> vertices) {
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

inline double coordinate_rounding(const PolygonMesh& mesh) {
  return coordinate_rounding(mesh.vertices);
}

}  // namespace tumble::detail
