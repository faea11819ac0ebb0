#pragma once
/// @file
/// What is said of bodies whose motion has left the finite numbers.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "tumble/core/require.hpp"

namespace tumble {

/// @addtogroup ensemble
/// @{

/// Bodies of an ensemble whose state is no longer finite.
struct LostBodies {
  std::size_t count = 0;
  std::size_t first = std::numeric_limits<std::size_t>::max();  ///< the first of them, if any

  void add(std::size_t body) { ++count, first = std::min(first, body); }
  LostBodies& operator+=(const LostBodies& other) {
    count += other.count;
    first = std::min(first, other.first);
    return *this;
  }
};

namespace detail {

/// @throws std::runtime_error if there are any, naming the first
inline void require_none(const LostBodies& lost) {
  if (lost.count == 0) return;
  detail::throw_error<std::runtime_error>(
      lost.count, " of the ensemble's bodies are no longer finite, the first is body ", lost.first,
      ". Take smaller steps, or a force that is finite wherever the bodies go");
}

}  // namespace detail

/// @}

}  // namespace tumble
