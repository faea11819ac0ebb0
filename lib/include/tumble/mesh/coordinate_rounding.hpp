#pragma once
/// @file
/// How coarsely the coordinates of a mesh were written: half a unit of a file's last decimal, or of
/// the last bit of a float, is rounding, not shape.
///
/// A file says `0.123457`; the double that is read is the nearest one to it, and of all decimals
/// with so few digits it is the nearest to one only. So the digits can be counted afterwards.

#include <algorithm>
#include <cmath>
#include <span>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {

/// 10^n, rounded once for |n| ≤ 22.
double power_of_ten(int n);

/// The power of ten of the first digit of x ≠ 0: 0 for 1.5.
inline int first_place(double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); }

/// Whether x is the double nearest to a decimal number whose last digit is at 10^−places.
bool is_decimal(double x, int places);

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

  /// The place of the last digit of a number that begins at 10^first.
  int last_place(int first, bool fixed) const { return fixed ? places : significant - 1 - first; }

  /// Half a unit of that digit; 0 if there are as many as a double has.
  double rounding(int first, bool fixed) const {
    return significant >= most ? 0 : power_of_ten(-last_place(first, fixed)) / 2;
  }
};

/// Whether many different numbers need the last digit: one may have been chosen so, and of many
/// numbers that were rounded nine in ten do.
bool many_need_last(const WrittenDigits& digits, bool fixed, std::span<const Vec3> vertices);

/// Half of what lies between the floats at x ≠ 0.
double half_gap(double x);

/// Whether a number needs one of a float's last two bits, as three floats in four do.
bool needs_last_bits(float x);

/// Whether many different numbers, and half of all, need a float's last bits. Chosen numbers do,
/// too, if they are large: 4649776.5 needs all. But beside them there are smaller ones that do not.
/// Where the decimals are coarser than floats, each seems to need all bits, and says nothing.
bool many_need_last_bits(const WrittenDigits& digits, bool fixed, std::span<const Vec3> vertices);

/// Whether some number needs the last bits of a float and a dozen decimals, as 10009.9990234375
/// does: nobody chooses one like it, so one is enough.
bool is_long_float(const WrittenDigits& digits, std::span<const Vec3> vertices);

/// Half of what lies between floats at the largest coordinate, if all were floats before they were
/// written with these digits; else 0. A float far away has few digits behind the point, and so many
/// before it that none of the decimals is rounded.
double rounding_of_floats(const WrittenDigits& digits, bool fixed, std::span<const Vec3> vertices);

/// The same, with a fixed number of places or not.
double rounding_of_floats(const WrittenDigits& digits, std::span<const Vec3> vertices);

/// The decimals that all coordinates are written with.
WrittenDigits written_digits(std::span<const Vec3> vertices);

/// Whether somebody may have chosen all coordinates: they are not floats, and few need the last
/// decimal.
bool may_be_chosen(std::span<const Vec3> vertices);

/// How far a coordinate may be from what it was before it was written: half a unit of the last
/// decimal, or of the last bit of a float [m]; 0 if the coordinates are doubles like any others, or
/// were chosen with so few digits (less than six, and not many with the last) that they may well be
/// exact.
double coordinate_rounding(std::span<const Vec3> vertices);

inline double coordinate_rounding(const PolygonMesh& mesh) {
  return coordinate_rounding(mesh.vertices);
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/coordinate_rounding.inl"
#endif
