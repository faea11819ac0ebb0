#pragma once
/// @file
/// Is a surface closed? One pass, no memory.
///
/// Each directed edge a → b adds +h(a, b) when a < b and −h(b, a) otherwise, modulo 2⁶⁴. The sum is
/// 0 when every edge is used equally often in both directions: then, and only then, the surface is
/// closed and its faces agree on what is outside. By chance it is 0 once in 2⁶⁴ meshes.
///
/// Source: a fingerprint as in Carter & Wegman, "Universal classes of hash functions", J.
/// Comput. Syst. Sci. 18 (1979); the mixer's constants are those of Steele, Lea & Flood's
/// SplitMix64, OOPSLA (2014).

#include <cstdint>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble {

/// A number that looks random, for the edge between vertices a and b (in either order).
inline std::uint64_t edge_hash(int a, int b) {
  const auto low = static_cast<std::uint64_t>(a < b ? a : b);
  const auto high = static_cast<std::uint64_t>(a < b ? b : a);
  std::uint64_t h = (low << 32 | high) + 0x9e3779b97f4a7c15u;
  h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9u;
  h = (h ^ h >> 27) * 0x94d049bb133111ebu;
  return h ^ h >> 31;
}

/// The sum of ±edge_hash over all directed edges of the mesh; 0: closed and consistently oriented.
inline std::uint64_t edge_balance(const PolygonMesh& mesh) {
  std::uint64_t sum = 0;
  const auto step = [&sum](int a, int b) {
    const std::uint64_t h = edge_hash(a, b);
    sum += a < b ? h : a > b ? 0 - h : 0;  // a corner that is repeated makes no edge
  };
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    if (face.empty()) continue;
    for (std::size_t k = 1; k < face.size(); ++k) step(face[k - 1], face[k]);
    step(face.back(), face.front());
  }
  return sum;
}

/// Whether every edge is used equally often in both directions. Parts that touch at a vertex, an
/// edge or a face are closed.
inline bool is_closed(const PolygonMesh& mesh) { return edge_balance(mesh) == 0; }

}  // namespace tumble
