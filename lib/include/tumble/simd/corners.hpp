#pragma once
/// @file
/// Reads the corners of as many triangles as a Pack has lanes, and sorts x, y and z apart.
///
/// Each corner is read as four doubles, the fourth of which belongs to the next vertex; exchanging
/// pieces between registers (a transposition) costs far less than reading number by number.

#include <cstddef>
#include <cstring>

#include "tumble/simd/point.hpp"

namespace tumble::simd {

/// @addtogroup simd
/// @{

/// Where the coordinates of a vertex are, and the number behind them.
TUMBLE_INLINE FourDoubles four_at(const double* coordinates, int vertex) {
  return load_four(coordinates + 3 * static_cast<std::ptrdiff_t>(vertex));
}

/// The corners k of 4 or 8 triangles, lane by lane in their order.
/// @param xyz     x, y, z of vertex 0, 1, …; one double behind the last one is read
/// @param corners of the first triangle: corner k of triangle i is corners[3 i + k]
template <class P>
TUMBLE_INLINE Point<P> load_corners(const double* xyz, const int* corners, int k) {
  const auto two = [=](int i, int j) __attribute__((always_inline))->EightDoubles {
    return __builtin_shufflevector(four_at(xyz, corners[3 * i + k]),
                                   four_at(xyz, corners[3 * j + k]), 0, 1, 2, 3, 4, 5, 6, 7);
  };
  if constexpr (lanes<P> == 8) {
    const EightDoubles a = two(0, 2), b = two(1, 3), c = two(4, 6), d = two(5, 7);
    const auto ab_xz = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto cd_xz = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto ab_y = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    const auto cd_y = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
    return {__builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5, 8, 9, 12, 13),
            __builtin_shufflevector(ab_y, cd_y, 0, 1, 4, 5, 8, 9, 12, 13),
            __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7, 10, 11, 14, 15)};
  } else {
    static_assert(lanes<P> == 4);
    // Number by number: without AVX gcc would exchange pieces by way of the stack.
    const double *a = xyz + 3 * std::ptrdiff_t{corners[k]},
                 *b = xyz + 3 * std::ptrdiff_t{corners[3 + k]};
    const double *c = xyz + 3 * std::ptrdiff_t{corners[6 + k]},
                 *d = xyz + 3 * std::ptrdiff_t{corners[9 + k]};
    return {P{a[0], b[0], c[0], d[0]}, P{a[1], b[1], c[1], d[1]}, P{a[2], b[2], c[2], d[2]}};
  }
}

/// The vertices of 4 or 8 triangles: which are corner 0, which 1, which 2.
template <class P>
struct CornerNumbers {
  Ints<P> of_corner[3];
};

/// Reads them, in the order of the triangles.
template <class P>
TUMBLE_INLINE CornerNumbers<P> load_numbers(const int* corners) {
  Ints<P> a, b, c;
  std::memcpy(&a, corners, sizeof a);
  std::memcpy(&b, corners + lanes<P>, sizeof b);
  std::memcpy(&c, corners + 2 * lanes<P>, sizeof c);
  if constexpr (lanes<P> == 8) {
    const auto ab0 = __builtin_shufflevector(a, b, 0, 3, 6, 9, 12, 15, 0, 0);
    const auto ab1 = __builtin_shufflevector(a, b, 1, 4, 7, 10, 13, 0, 0, 0);
    const auto ab2 = __builtin_shufflevector(a, b, 2, 5, 8, 11, 14, 0, 0, 0);
    return {__builtin_shufflevector(ab0, c, 0, 1, 2, 3, 4, 5, 10, 13),
            __builtin_shufflevector(ab1, c, 0, 1, 2, 3, 4, 8, 11, 14),
            __builtin_shufflevector(ab2, c, 0, 1, 2, 3, 4, 9, 12, 15)};
  } else {
    const auto ab0 = __builtin_shufflevector(a, b, 0, 3, 6, 0);
    const auto ab1 = __builtin_shufflevector(a, b, 1, 4, 7, 0);
    const auto ab2 = __builtin_shufflevector(a, b, 2, 5, 0, 0);
    return {__builtin_shufflevector(ab0, c, 0, 1, 2, 5),
            __builtin_shufflevector(ab1, c, 0, 1, 2, 6),
            __builtin_shufflevector(ab2, c, 0, 1, 4, 7)};
  }
}

/// @}

}  // namespace tumble::simd
