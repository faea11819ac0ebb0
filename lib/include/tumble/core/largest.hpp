#pragma once
/// @file
/// The largest of some numbers, of which none is lost: std::max() drops a NaN, as the case may be.

#include <initializer_list>

namespace tumble::detail {

/// The largest number; NaN if one of them is.
inline double largest(std::initializer_list<double> numbers) {
  double most = *numbers.begin();
  for (const double number : numbers)
    if (most == most && !(number <= most)) most = number;
  return most;
}

}  // namespace tumble::detail
