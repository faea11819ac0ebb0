#pragma once
/// @file
/// Where vertical lines meet a surface: each triangle is drawn onto the lines that pass it.
///
/// Source: Pineda, "A parallel algorithm for polygon rasterization", SIGGRAPH (1988).

#include <algorithm>
#include <cmath>
#include <vector>

#include "tumble/core/rounding.hpp"
#include "tumble/mesh/components.hpp"
#include "tumble/mesh/line_height.hpp"
#include "tumble/mesh/near_lines.hpp"
#include "tumble/mesh/orientation.hpp"

namespace tumble::detail {

/// One crossing of a vertical line and a face.
struct LineHit {
  PlanePoint line;
  int face;       ///< which face
  int part;       ///< of which part of the surface
  int direction;  ///< 1: going up, the line enters the body; −1: it leaves
  double z;       ///< height [m]
  double error;   ///< what rounding, of the vertices too, may have done to z at most [m]
};

/// All crossings, those of each line from below to above; those of line i from first[i] to
/// first[i + 1].
struct LineHits {
  std::vector<LineHit> hits;
  std::vector<std::size_t> first;

  std::span<const LineHit> of_line(std::size_t i) const {
    return std::span<const LineHit>(hits).subspan(first[i], first[i + 1] - first[i]);
  }
  std::size_t line_count() const { return first.size() - 1; }

  /// Adds the hits of further lines.
  void append(const LineHits& more) {
    const std::size_t shift = hits.size();
    first.pop_back();
    for (const std::size_t k : more.first) first.push_back(shift + k);
    hits.insert(hits.end(), more.hits.begin(), more.hits.end());
  }
};

/// Fills in z and error of a hit on the triangle a, b, c.
/// @param largest the largest absolute coordinate of the mesh: its vertices are known to ± ε
/// largest
inline void set_height(LineHit& hit, const Vec3& a, const Vec3& b, const Vec3& c, double largest) {
  const LineWeights weights(a, b, c, hit.line);
  const double low = std::min({a.z(), b.z(), c.z()}), high = std::max({a.z(), b.z(), c.z()});
  // A shift of ε largest sideways moves z by as much times the slope, at most height / width.
  const double blur = 8 * unit_roundoff * largest, all = weights.area;
  const double slope =
      all > 0 ? (high - low) * ((b - a).lpNorm<1>() + (c - a).lpNorm<1>()) / all : 0;
  hit.z = weights.height(a, b, c);
  hit.error = std::min(blur * (1 + slope), high - low + blur);
}

/// Sorts hits by line (a counting sort) and, on each line, by height.
inline LineHits sort_hits(const std::vector<LineHit>& hits, const std::vector<int>& line_of_hit,
                          int line_count) {
  LineHits sorted;
  sorted.first.assign(static_cast<std::size_t>(line_count) + 1, 0);
  for (const int line : line_of_hit) ++sorted.first[static_cast<std::size_t>(line)];
  std::size_t sum = 0;
  for (std::size_t& n : sorted.first) n = sum += n;
  sorted.hits.resize(hits.size());
  for (std::size_t k = hits.size(); k-- > 0;)
    sorted.hits[--sorted.first[static_cast<std::size_t>(line_of_hit[k])]] = hits[k];
  for (std::size_t i = 0; i < sorted.line_count(); ++i)
    std::sort(sorted.hits.begin() + static_cast<std::ptrdiff_t>(sorted.first[i]),
              sorted.hits.begin() + static_cast<std::ptrdiff_t>(sorted.first[i + 1]),
              [](const LineHit& g, const LineHit& h) { return g.z < h.z; });
  return sorted;
}

/// Gathers the crossings of lines and triangles.
template <class Lines>
class HitCollector {
 public:
  /// @param largest the largest absolute coordinate of the mesh
  HitCollector(const PolygonMesh& mesh, const Components& surface, double largest,
               const Lines& lines)
      : mesh_(mesh), surface_(surface), largest_(largest), lines_(lines) {}

  void add(int face, const std::array<int, 3>& t) {
    const int part = surface_.of(t[0]);
    if (part < 0) return;  // three times the same vertex
    const Vec3 &a = mesh_.vertex(t[0]), &b = mesh_.vertex(t[1]), &c = mesh_.vertex(t[2]);
    lines_.for_each_in(rectangle_of(a, b, c), [&](int i, const PlanePoint& line) {
      const int crossing = line_crossing(a, b, c, line.x(), line.y());
      if (crossing == 0) return;
      hits_.push_back({line, face, part, -crossing, 0, 0});
      set_height(hits_.back(), a, b, c, largest_);
      line_of_hit_.push_back(i);
    });
  }

  LineHits sorted() const { return sort_hits(hits_, line_of_hit_, lines_.size()); }

 private:
  const PolygonMesh& mesh_;
  const Components& surface_;
  double largest_;
  const Lines& lines_;
  std::vector<LineHit> hits_;
  std::vector<int> line_of_hit_;
};

/// A vertical line through each part: through the middle of its widest triangle.
inline std::vector<PlanePoint> lines_through_parts(const PolygonMesh& mesh,
                                                   const Components& surface) {
  std::vector<PlanePoint> lines;
  for (const std::array<int, 3>& t : widest_triangles(mesh, surface)) {
    const Vec3& a = mesh.vertex(t[0]);
    const Vec3 middle = a + (mesh.vertex(t[1]) - a) / 3 + (mesh.vertex(t[2]) - a) / 3;
    lines.emplace_back(middle.x(), middle.y());
  }
  return lines;
}

/// Where a bundle of vertical lines meets the mesh: those of a lattice, and when it has several
/// parts, one through each.
/// @param box  around all vertices
/// @param near all triangles that may meet a line of the lattice
inline LineHits hits_of_bundle(const PolygonMesh& mesh, const Components& surface,
                               const Eigen::AlignedBox3d& box, const LineLattice& lattice,
                               const TrianglesNearLines& near) {
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  HitCollector on_lattice(mesh, surface, largest, lattice);
  for (const FaceTriangle& triangle : near.list) on_lattice.add(triangle.face, triangle.vertices);
  LineHits hits = on_lattice.sorted();
  if (surface.parts.size() == 1) return hits;
  const LineList through_parts(box, lines_through_parts(mesh, surface));
  HitCollector on_parts(mesh, surface, largest, through_parts);
  for_each_triangle(mesh, [&](int f, const std::array<int, 3>& t) { on_parts.add(f, t); });
  hits.append(on_parts.sorted());
  return hits;
}

}  // namespace tumble::detail
