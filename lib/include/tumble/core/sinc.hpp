#pragma once
/// @file
/// sin x / x, which the exponential maps of rotations share.

#include <cmath>

namespace tumble::detail {

/// sin x / x, with its limit 1 at 0. No series is needed: the quotient itself is accurate
/// for tiny x.
template <class T>
T sinc(const T& x) {
  using std::sin;
  return x == T(0) ? T(1) : sin(x) / x;
}

}  // namespace tumble::detail
