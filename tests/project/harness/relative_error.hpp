#pragma once
/// @file
/// How far a number is from what it should be. (doctest's Approx adds an absolute part of
/// the same size.)

#include <cmath>

namespace tumble::test {

/// |value − exact| / |exact|; NaN, which no comparison passes, if something is not finite.
inline double relative_error(double value, double exact) {
  return std::abs(value - exact) / std::abs(exact);
}

}  // namespace tumble::test
