#pragma once
/// @file
/// Times that one can divide by.

#include <cmath>
#include <limits>

namespace tumble::detail {

/// Whether a time is 0, or a number with all its digits: what is shorter than 2e-308 has fewer, and
/// one divided by it is infinite.
template <class T>
bool is_time(const T& t) {
  using std::abs, std::isfinite;  // a dual number brings its own
  return t == T(0) || (isfinite(t) && abs(t) >= T(std::numeric_limits<T>::min()));
}

}  // namespace tumble::detail
