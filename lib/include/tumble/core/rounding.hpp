#pragma once
/// @file
/// What one rounding of a double costs.

namespace tumble::detail {

/// Unit roundoff of double: the relative error of one rounding to nearest is at most 2⁻⁵³.
/// Source: IEEE 754-2019; Higham, Accuracy and Stability of Numerical Algorithms, 2002, (2.3).
inline constexpr double unit_roundoff = 0x1p-53;

}  // namespace tumble::detail
