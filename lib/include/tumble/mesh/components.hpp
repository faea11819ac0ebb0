#pragma once
/// @file
/// The parts of a surface, faces connected through shared vertices, and what each part encloses.
///
/// Source: for the parts Tarjan, "Efficiency of a good but not linear set union algorithm", J. ACM
/// 22 (1975); for their volumes see enclosed_volume.hpp.

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "tumble/mesh/enclosed_volume.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {

/// One part of a surface.
struct Component {
  int a_vertex = -1;    ///< one of its vertices
  double volume = 0;    ///< enclosed volume [m³], negative when its faces look inwards
  double rounding = 0;  ///< what rounding may have done to `volume` at most [m³]
  double area = 0;      ///< of its surface, or up to √3 times as much [m²]
};

/// Whether a surface encloses no more than rounding to `by` [m] may make of nothing: each corner
/// moves by up to √3 roundings, and each of two copies has half of the area.
inline bool is_rounding(const Component& surface, double by) {
  return !(std::abs(surface.volume) > 2 * by * surface.area + surface.rounding);
}

/// The parts of a surface, and which part each vertex belongs to (−1: to no face).
struct Components {
  std::vector<Component> parts;
  std::vector<int> of_vertex;

  int of(int vertex) const { return of_vertex[static_cast<std::size_t>(vertex)]; }
};

/// Joins what hangs together: after `join(a, b)` both have the same root.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void join(int a, int b) {
    if (at(a) == at(b)) return;
    const int ra = root(a), rb = root(b);
    at(ra < rb ? rb : ra) = ra < rb ? ra : rb;
  }
  /// The root of each element.
  std::vector<int> roots() {
    // A root is the smallest of its set: whatever an element points to is done before it.
    for (int& parent : parent_) parent = at(parent);
    return std::move(parent_);
  }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

/// Finds and numbers the parts. Volumes are not computed yet.
Components label_components(const PolygonMesh& mesh);

/// What each part encloses, without factors.
std::vector<EnclosedVolume> enclosed_by_parts(const PolygonMesh& mesh, const Components& surface);

/// Measures the parts again that double cannot tell from flat ones, with twice the digits: needles
/// and plates that lie askew enclose something after all.
void measure_thin_parts(const PolygonMesh& mesh, Components& surface);

/// The parts with what they enclose.
/// @param mesh indices in range, positions finite
/// @param all  what the whole mesh encloses, about a point on it or near
Components components(const PolygonMesh& mesh, const EnclosedVolume& all);

/// The first face of each part.
std::vector<int> first_faces(const PolygonMesh& mesh, const Components& surface);

/// For each part its triangle that looks largest from above.
std::vector<std::array<int, 3>> widest_triangles(const PolygonMesh& mesh,
                                                 const Components& surface);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/components.inl"
#endif
