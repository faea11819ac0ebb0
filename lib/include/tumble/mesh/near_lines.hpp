#pragma once
/// @file
/// Which of all triangles may meet one of a thousand vertical lines? Few: they are found by packs.

#include <array>
#include <vector>

#include "tumble/mesh/line_lattice.hpp"
#include "tumble/mesh/sum_over_blocks.hpp"
#include "tumble/simd/corners.hpp"

namespace tumble::detail {

/// A triangle of a face: the vertices at its corners.
struct FaceTriangle {
  int face;
  std::array<int, 3> vertices;
};

/// Triangles that may meet a line of a lattice.
struct TrianglesNearLines {
  std::vector<FaceTriangle> list;

  TrianglesNearLines& operator+=(const TrianglesNearLines& more) {
    list.insert(list.end(), more.list.begin(), more.list.end());
    return *this;
  }
};

/// Finds those of a block.
struct BlockNearLines {
  const TriangleBlock& block;
  const LatticeFilter& filter;
  TrianglesNearLines& result;

  template <class P, simd::Fma>
  TUMBLE_INLINE void run() const {
    for (int i = 0; i < block.size; i += simd::lanes<P>) {
      const P near = near_lines<P>(block.corners + 3 * i);
      if (simd::sum_of_lanes(near) == 0) continue;
      for (int k = 0; k < simd::lanes<P>; ++k)
        if (near[k] != 0 && i + k < block.size - block.padding) add(i + k);
    }
  }

  template <class P>
  TUMBLE_INLINE P near_lines(const int* corners) const {
    const auto a = simd::load_corners<P>(block.coordinates, corners, 0),
               b = simd::load_corners<P>(block.coordinates, corners, 1),
               c = simd::load_corners<P>(block.coordinates, corners, 2);
    return filter.near<P>(
        simd::smaller(simd::smaller(a.x, b.x), c.x), simd::larger(simd::larger(a.x, b.x), c.x),
        simd::smaller(simd::smaller(a.y, b.y), c.y), simd::larger(simd::larger(a.y, b.y), c.y));
  }

  void add(int triangle) const {
    const int* v = block.vertices + 3 * triangle;
    result.list.push_back({block.face(triangle), {v[0], v[1], v[2]}});
  }
};

}  // namespace tumble::detail
