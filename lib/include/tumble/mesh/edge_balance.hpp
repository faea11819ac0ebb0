#pragma once
/// @file
/// Is a surface closed? One pass, no memory.
///
/// Every vertex is put to a place of a plane that depends on its number as if drawn by lot. A
/// closed surface, spread out there, covers as much turned one way as the other: the signed areas
/// of its faces add up to 0, wherever the vertices are. What does not is the area that the open
/// edges go round. Edges that are used equally often in both directions cancel, and no others do;
/// by chance the sum is 0 about once in 2⁵⁷ open meshes. All is computed with integers, modulo 2⁶⁴.
///
/// Source: a fingerprint as in Carter & Wegman, "Universal classes of hash functions", J.
/// Comput. Syst. Sci. 18 (1979); the mixer's constants are those of Steele, Lea & Flood's
/// SplitMix64, OOPSLA (2014).

#include <cstdint>

#include "tumble/core/inline.hpp"
#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/mesh/triangle_blocks.hpp"
#include "tumble/simd/corners.hpp"
#include "tumble/simd/loop_options.hpp"

namespace tumble::detail {

/// A place of the plane with whole coordinates, −2³¹ … 2³¹ − 1. @tparam L integers of 64 bits
template <class L>
struct RandomPlace {
  L u, v;

  /// The place of vertex number n.
  TUMBLE_INLINE explicit RandomPlace(const L& n) {
    L h = (n + 1) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32)) * 0x94d049bb133111ebu;
    h ^= h >> 29;
    u = (h >> 32) - 0x80000000u;
    v = (h & 0xffffffffu) - 0x80000000u;
  }
};

/// Twice the signed area between the random places of three vertices, modulo 2⁶⁴.
/// @param a, b, c vertex numbers
template <class L>
TUMBLE_INLINE L random_area(const L& a, const L& b, const L& c) {
  const RandomPlace<L> p(a), q(b), r(c);
  return (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
}

/// The random areas of a pack of triangles.
/// @param vertices three a triangle
template <class P>
TUMBLE_INLINE simd::Integers<P> random_areas(const int* vertices) {
  using L = simd::Integers<P>;
  const simd::CornerNumbers<P> numbers = simd::load_numbers<P>(vertices);
  return random_area<L>(__builtin_convertvector(numbers.of_corner[0], L),
                        __builtin_convertvector(numbers.of_corner[1], L),
                        __builtin_convertvector(numbers.of_corner[2], L));
}

/// The sum of all lanes, modulo 2⁶⁴.
template <class P>
TUMBLE_INLINE std::uint64_t sum_of_lanes_modulo(const simd::Integers<P>& x) {
  std::uint64_t sum = 0;
  for (int i = 0; i < simd::lanes<P>; ++i) sum += x[i];
  return sum;
}

/// Adds up the random areas of a block.
struct BlockBalance {
  const TriangleBlock& block;
  std::uint64_t& sum;

  template <class P, simd::Fma>
  TUMBLE_INLINE void run() const {
    simd::Integers<P> areas{};
    for (int i = 0; i < block.size; i += simd::lanes<P>)
      areas += random_areas<P>(block.vertices + 3 * i);
    sum += sum_of_lanes_modulo<P>(areas);
  }
};

/// Whether every edge is used equally often in both directions. Parts that touch at a vertex, an
/// edge or a face are closed; a corner that is repeated makes no edge.
/// @param mesh indices in range
bool is_closed(const PolygonMesh& mesh, const simd::LoopOptions& options = {});

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/edge_balance.inl"
#endif
