#pragma once
/// @file
/// Which of all triangles may meet one of some thousand lines along each axis? Few: they are found
/// by packs.

#include <array>
#include <vector>

#include "tumble/mesh/line_lattice.hpp"
#include "tumble/mesh/sum_over_blocks.hpp"
#include "tumble/mesh/view.hpp"
#include "tumble/simd/corners.hpp"

namespace tumble::detail {

/// A triangle of a face: the vertices at its corners.
struct FaceTriangle {
  int face;
  std::array<int, 3> vertices;
};

/// Triangles that may meet a line of a lattice, for each of the three axes that lines run along.
struct TrianglesNearLines {
  std::array<std::vector<FaceTriangle>, 3> along;

  TrianglesNearLines& operator+=(const TrianglesNearLines& more) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      along[axis].insert(along[axis].end(), more.along[axis].begin(), more.along[axis].end());
    return *this;
  }
};

/// Lattices of lines along x, y and z, over the same box.
struct LineLattices {
  std::array<LineLattice, 3> along;

  LineLattices(const Eigen::AlignedBox3d& box, int count)
      : along{LineLattice(View{0}.box(box), count), LineLattice(View{1}.box(box), count),
              LineLattice(View{2}.box(box), count)} {}
};

/// What leaves out triangles that meet none of their lines.
using LatticeFilters = std::array<LatticeFilter, 3>;

inline LatticeFilters filters_of(const LineLattices& lattices) {
  return {lattices.along[0].filter(), lattices.along[1].filter(), lattices.along[2].filter()};
}

/// The least and the largest of three.
template <class P>
struct Extent {
  P low, high;

  TUMBLE_INLINE Extent(const P& a, const P& b, const P& c)
      : low(simd::smaller(simd::smaller(a, b), c)), high(simd::larger(simd::larger(a, b), c)) {}
};

/// Notes those of a pack that are in the lanes where `near` is not 0.
/// @param first the number of its first triangle in the block
template <class P>
TUMBLE_INLINE void note_lanes(const TriangleBlock& block, int first, const P& near,
                              std::vector<FaceTriangle>& list) {
  if (simd::sum_of_lanes(near) == 0) return;
  for (int k = 0; k < simd::lanes<P>; ++k) {
    if (near[k] == 0 || first + k >= block.size - block.padding) continue;
    const int* v = block.vertices + 3 * (first + k);
    list.push_back({block.face(first + k), {v[0], v[1], v[2]}});
  }
}

/// Notes the triangles of a pack that may meet a line.
template <class P>
TUMBLE_INLINE void note_near_lines(const TriangleBlock& block, const LatticeFilters& filters,
                                   int first, const simd::Point<P>& a, const simd::Point<P>& b,
                                   const simd::Point<P>& c, TrianglesNearLines& result) {
  const Extent<P> x(a.x, b.x, c.x), y(a.y, b.y, c.y), z(a.z, b.z, c.z);
  note_lanes<P>(block, first, filters[0].near<P>(y.low, y.high, z.low, z.high), result.along[0]);
  note_lanes<P>(block, first, filters[1].near<P>(z.low, z.high, x.low, x.high), result.along[1]);
  note_lanes<P>(block, first, filters[2].near<P>(x.low, x.high, y.low, y.high), result.along[2]);
}

}  // namespace tumble::detail
