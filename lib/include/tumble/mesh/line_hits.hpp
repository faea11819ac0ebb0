#pragma once
/// @file
/// Where lines along an axis meet a surface: each triangle is drawn onto the lines that pass it.
///
/// Source: Pineda, "A parallel algorithm for polygon rasterization", SIGGRAPH (1988).

#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/near_lines.hpp"
#include "tumble/mesh/orientation.hpp"
#include "tumble/mesh/view.hpp"

namespace tumble::detail {

/// One crossing of a line and a face, in the coordinates of a view.
struct LineHit {
  PlanePoint line;
  int face;       ///< which face
  int part;       ///< of which part of the surface
  int direction;  ///< 1: going up, the line enters the body; −1: it leaves
  View view;      ///< which coordinates line and z are
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
};

/// Fills in z and error of a hit on the triangle a, b, c.
/// @param blur how far rounding may have moved a coordinate of a vertex [m]
void set_height(LineHit& hit, const Vec3& a, const Vec3& b, const Vec3& c, double blur);

/// Sorts hits by line (a counting sort) and, on each line, by height.
LineHits sort_hits(const std::vector<LineHit>& hits, const std::vector<int>& line_of_hit,
                   int line_count);

/// What the lines of a view meet.
struct LinesOnMesh {
  const PolygonMesh& mesh;
  const Components& surface;
  View view;
  double blur;  ///< how far rounding may have moved a coordinate of a vertex [m]
};

/// Gathers the crossings of lines and triangles.
template <class Lines>
class HitCollector {
 public:
  HitCollector(const LinesOnMesh& what, const Lines& lines) : what_(what), lines_(lines) {}

  void add(int face, const std::array<int, 3>& t) {
    const int part = what_.surface.of(t[0]);
    if (part < 0) return;  // three times the same vertex
    const auto corner = [&](int v) { return what_.view.point(what_.mesh.vertex(v)); };
    const Vec3 a = corner(t[0]), b = corner(t[1]), c = corner(t[2]);
    lines_.for_each_in(rectangle_of(a, b, c), [&](int i, const PlanePoint& line) {
      const int crossing = line_crossing(a, b, c, line.x(), line.y());
      if (crossing == 0) return;
      hits_.push_back({line, face, part, -crossing, what_.view, 0, 0});
      set_height(hits_.back(), a, b, c, what_.blur);
      line_of_hit_.push_back(i);
    });
  }

  LineHits sorted() const { return sort_hits(hits_, line_of_hit_, lines_.size()); }

 private:
  LinesOnMesh what_;
  const Lines& lines_;
  std::vector<LineHit> hits_;
  std::vector<int> line_of_hit_;
};

/// Where lines anywhere meet the mesh.
LineHits hits_of_lines(const LinesOnMesh& what, const LineList& lines);

/// The same, if it is known which triangles may meet one.
LineHits hits_of_lines(const LinesOnMesh& what, const LineList& lines,
                       const std::vector<FaceTriangle>& near);

/// Where the lines of a lattice meet the mesh.
/// @param near all triangles that may meet one
LineHits hits_of_lattice(const LinesOnMesh& what, const LineLattice& lattice,
                         const std::vector<FaceTriangle>& near);

/// A vertical line through each part: through the middle of its widest triangle.
std::vector<PlanePoint> lines_through_parts(const PolygonMesh& mesh, const Components& surface);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/line_hits.inl"
#endif
