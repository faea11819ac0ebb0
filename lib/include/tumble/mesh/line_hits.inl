#pragma once

#include "tumble/mesh/line_hits.hpp"

#include <algorithm>
#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/mesh/line_height.hpp"

namespace tumble::detail {

TUMBLE_BODY void set_height(LineHit& hit, const Vec3& a, const Vec3& b, const Vec3& c,
                            double blur) {
  const LineWeights weights(a, b, c, hit.line);
  const double low = std::min({a.z(), b.z(), c.z()}), high = std::max({a.z(), b.z(), c.z()});
  // A shift sideways moves z by as much times the slope, at most height / width.
  const double all = weights.area;
  const double slope =
      all > 0 ? (high - low) * ((b - a).lpNorm<1>() + (c - a).lpNorm<1>()) / all : 0;
  hit.z = weights.height(a, b, c);
  hit.error = std::min(blur * (1 + slope), high - low + blur);
}

TUMBLE_BODY LineHits sort_hits(const std::vector<LineHit>& hits,
                               const std::vector<int>& line_of_hit, int line_count) {
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

TUMBLE_BODY LineHits hits_of_lines(const LinesOnMesh& what, const LineList& lines) {
  HitCollector collector(what, lines);
  for_each_triangle(what.mesh, [&](int f, const std::array<int, 3>& t) { collector.add(f, t); });
  return collector.sorted();
}

/// What the lines of a list or a lattice meet of some triangles.
template <class Lines>
LineHits hits_on(const LinesOnMesh& what, const Lines& lines,
                 const std::vector<FaceTriangle>& near) {
  HitCollector collector(what, lines);
  for (const FaceTriangle& triangle : near) collector.add(triangle.face, triangle.vertices);
  return collector.sorted();
}

TUMBLE_BODY LineHits hits_of_lines(const LinesOnMesh& what, const LineList& lines,
                                   const std::vector<FaceTriangle>& near) {
  return hits_on(what, lines, near);
}

TUMBLE_BODY LineHits hits_of_lattice(const LinesOnMesh& what, const LineLattice& lattice,
                                     const std::vector<FaceTriangle>& near) {
  return hits_on(what, lattice, near);
}

TUMBLE_BODY std::vector<PlanePoint> lines_through_parts(const PolygonMesh& mesh,
                                                        const Components& surface) {
  std::vector<PlanePoint> lines;
  for (const std::array<int, 3>& t : widest_triangles(mesh, surface)) {
    const Vec3& a = mesh.vertex(t[0]);
    const Vec3 middle = a + (mesh.vertex(t[1]) - a) / 3 + (mesh.vertex(t[2]) - a) / 3;
    lines.emplace_back(middle.x(), middle.y());
  }
  return lines;
}

}  // namespace tumble::detail
