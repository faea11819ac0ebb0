#pragma once
/// @file
/// The sum over all tetrahedra of a mesh, as many at once as the processor can, in doubles or in
/// pairs of doubles.
///
/// Eight terms are added up lane by lane, then such short sums in pairs of doubles, and blocks of a
/// few hundred triangles in double-double: the error of a million terms is that of eight. The
/// blocks are the same however many threads there are, and so is every bit of the result.

#include <algorithm>

#include "tumble/mass/rounding_sums.hpp"
#include "tumble/mass/tetrahedron.hpp"
#include "tumble/mesh/reference_point.hpp"
#include "tumble/mesh/sum_over_blocks.hpp"
#include "tumble/simd/corners.hpp"

namespace tumble::detail {

/// What the triangles of a mesh add up to.
struct TetrahedronSums {
  Moments<simd::DoubleDouble> raw;  ///< without their factors: see raw_moments()
  RoundingSums<double> rounding;    ///< what their rounding is bounded by

  TetrahedronSums& operator+=(const TetrahedronSums& other) {
    raw += other.raw;
    rounding += other.rounding;
    return *this;
  }
};

/// x − y, rounded.
template <class P>
TUMBLE_INLINE void subtract(const P& x, const P& y, P& difference) {
  difference = x - y;
}
/// x − y, exactly.
template <class P, Fma fma>
TUMBLE_INLINE void subtract(const P& x, const P& y, Pair<P, fma>& difference) {
  difference = two_diff<fma>(x, y);
}

template <class Number, class P>
TUMBLE_INLINE simd::Point<Number> difference(const simd::Point<P>& x, const simd::Point<P>& y) {
  simd::Point<Number> d;
  subtract(x.x, y.x, d.x);
  subtract(x.y, y.y, d.y);
  subtract(x.z, y.z, d.z);
  return d;
}

template <class P, Fma fma>
simd::DoubleDouble total(const Pair<P, fma>& lanes) {
  simd::DoubleDouble sum;
  for (int i = 0; i < simd::lanes<P>; ++i)
    sum += simd::DoubleDouble(Pair<double>{lanes.hi[i], lanes.lo[i]});
  return sum;
}
template <class T>
Moments<simd::DoubleDouble> total(const Moments<T>& m) {
  return {total(m.one), total(m.x),  total(m.y),  total(m.z),  total(m.xx),
          total(m.yy),  total(m.zz), total(m.xy), total(m.yz), total(m.zx)};
}

/// How many terms of a lane are added up before their sum goes into a pair of doubles; see
/// rounding_sums.hpp.
inline constexpr int short_sum = 8;

/// Sums one block. `Numbers<P, fma>` is what it computes with: P or a Pair of them.
template <template <class, Fma> class Numbers>
struct BlockSum {
  const TriangleBlock& block;
  const Vec3& reference;
  TetrahedronSums& result;

  template <class P, Fma fma>
  TUMBLE_INLINE void run() const {
    using Number = Numbers<P, fma>;
    Moments<Pair<P, fma>> moments;
    RoundingSums<P> rounding;
    const simd::Point<P> p{P{} + reference.x(), P{} + reference.y(), P{} + reference.z()};
    for (int i = 0; i < block.size;) {
      Moments<Number> few;
      const int end = std::min(block.size, i + short_sum * simd::lanes<P>);
      for (; i < end; i += simd::lanes<P>) {
        const int* corners = block.corners + 3 * i;
        fetch_ahead<P>(corners);
        const simd::Point<P> x = simd::load_corners<P>(block.coordinates, corners, 0),
                             y = simd::load_corners<P>(block.coordinates, corners, 1),
                             z = simd::load_corners<P>(block.coordinates, corners, 2);
        // Edges from the corners as they are: they may be far shorter than what p is away.
        const simd::Point<Number> e = difference<Number>(y, x), f = difference<Number>(z, x),
                                  a = difference<Number>(x, p), b = difference<Number>(y, p),
                                  c = difference<Number>(z, p);
        few += raw_moments<fma>(simd::dot<fma>(cross(e, f), a), a, b, c);
        rounding.add(leading(a), leading(b), leading(c), leading(e), leading(f));
      }
      moments += few;
    }
    result.raw += total(moments);
    result.rounding += {simd::sum_of_lanes(rounding.volume), simd::sum_of_lanes(rounding.second)};
  }
};

template <class P, Fma>
using InDoubles = P;
template <class P, Fma fma>
using InPairs = Pair<P, fma>;

template <template <class, Fma> class Numbers>
TetrahedronSums sum_tetrahedra(const PolygonMesh& mesh, const Vec3& reference,
                               const simd::LoopOptions& options) {
  const auto add = [&](const TriangleBlock& block, TetrahedronSums& sum) {
    dispatch(options.instructions, BlockSum<Numbers>{block, reference, sum});
  };
  return sum_over_blocks<TetrahedronSums>(mesh, options, add);
}

/// The sums with everything in double: about 1e-15 for ordinary shapes. Thin shapes that lie askew
/// lose digits; `rounding` says how many.
/// @param mesh      indices in range
/// @param reference the point that the moments are about; near the body nothing cancels [m]
inline TetrahedronSums sum_in_doubles(const PolygonMesh& mesh, const Vec3& reference,
                                      const simd::LoopOptions& options = {}) {
  return detail::sum_tetrahedra<detail::InDoubles>(mesh, reference, options);
}

/// The sums in pairs of doubles, about 30 digits: of what a double can show all, on every shape.
inline TetrahedronSums sum_in_pairs(const PolygonMesh& mesh, const Vec3& reference,
                                    const simd::LoopOptions& options = {}) {
  return detail::sum_tetrahedra<detail::InPairs>(mesh, reference, options);
}

}  // namespace tumble::detail
