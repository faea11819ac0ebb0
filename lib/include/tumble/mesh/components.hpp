#pragma once
/// @file
/// The parts of a surface: faces that hang together by shared vertices, and what
/// each part encloses.
///
/// 6 V = Σ (a − o) · ((b − a) × (c − a)) over the part's triangles, o one of its own vertices:
/// nothing is lost when the part is small or far away. Source: the divergence theorem; for the
/// parts Tarjan, "Efficiency of a good but not linear set union algorithm", J. ACM 22 (1975).

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/mesh/precise_volume.hpp"

namespace tumble {

/// One part of a surface.
struct Component {
  int a_vertex = -1;    ///< one of its vertices
  double volume = 0;    ///< enclosed volume [m³], negative when its faces look inwards
  double rounding = 0;  ///< what rounding may have done to `volume` at most [m³]
};

/// The parts of a surface, and which part each vertex belongs to (−1: to no face).
struct Components {
  std::vector<Component> parts;
  std::vector<int> of_vertex;
  int doubtful_faces = 0;  ///< faces that may have no area: degeneracy() knows

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
inline Components label_components(const PolygonMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    for (std::size_t k = 1; k < face.size(); ++k) sets.join(face[0], face[k]);
  }
  Components result;
  result.of_vertex = sets.roots();
  std::vector<int> label(mesh.vertices.size(), -1);  // of a root; a vertex without faces is alone
  for (std::size_t v = 0; v < label.size(); ++v) {
    const int root = result.of_vertex[v];
    if (root == static_cast<int>(v) || label[static_cast<std::size_t>(root)] >= 0) continue;
    label[static_cast<std::size_t>(root)] = static_cast<int>(result.parts.size());
    result.parts.emplace_back().a_vertex = root;
  }
  for (int& v : result.of_vertex) v = label[static_cast<std::size_t>(v)];
  return result;
}

/// Adds the triangle a, b, c to what a part encloses.
/// @return whether its area may be 0
inline bool add_triangle(Component& part, const Vec3& o, const Vec3& a, const Vec3& b,
                         const Vec3& c) {
  const Vec3 r = a - o, u = b - a, v = c - a, n = u.cross(v);
  const double size = u.lpNorm<1>() * v.lpNorm<1>();
  constexpr double eps = 0x1p-53;
  part.volume += r.dot(n);
  part.rounding += r.lpNorm<1>() * size;
  return !(n.lpNorm<1>() > 8 * eps * size);
}

/// Measures the parts again that double cannot tell from flat ones, with twice the digits: needles
/// and plates that lie askew enclose something after all.
inline void measure_thin_parts(const PolygonMesh& mesh, Components& surface) {
  std::vector<DoubleDouble> six_volume(surface.parts.size());
  const auto is_thin = [](const Component& part) { return std::abs(part.volume) <= part.rounding; };
  if (std::none_of(surface.parts.begin(), surface.parts.end(), is_thin)) return;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const int i = surface.of(t[0]);
    if (i < 0 || !is_thin(surface.parts[static_cast<std::size_t>(i)])) return;
    const Vec3& o = mesh.vertex(surface.parts[static_cast<std::size_t>(i)].a_vertex);
    six_volume[static_cast<std::size_t>(i)] +=
        precise_six_volume(mesh.vertex(t[0]), mesh.vertex(t[1]), mesh.vertex(t[2]), o);
  });
  for (std::size_t i = 0; i < surface.parts.size(); ++i) {
    if (!is_thin(surface.parts[i])) continue;
    surface.parts[i].volume = double(six_volume[i]) / 6;
    surface.parts[i].rounding *= 0x1p-48;  // products and sums are good to 2⁻¹⁰⁴ and not to 2⁻⁵³
  }
}

/// The parts with what they enclose.
/// @param mesh indices in range, positions finite
inline Components components(const PolygonMesh& mesh) {
  Components result = label_components(mesh);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    const int i = face.empty() ? -1 : result.of(face[0]);
    bool doubtful = face.size() < 3 || i < 0;
    for (std::size_t k = 2; k < face.size() && i >= 0; ++k) {
      Component& part = result.parts[static_cast<std::size_t>(i)];
      doubtful |= add_triangle(part, mesh.vertex(part.a_vertex), mesh.vertex(face[0]),
                               mesh.vertex(face[k - 1]), mesh.vertex(face[k]));
    }
    result.doubtful_faces += doubtful;
  }
  // A term has 8 roundings at most; those of the sum grow like √n when they fall at random.
  constexpr double eps = 0x1p-53;
  for (Component& part : result.parts) {
    part.volume /= 6;
    part.rounding *= (8 + std::sqrt(static_cast<double>(mesh.corners.size()))) * eps / 6;
  }
  measure_thin_parts(mesh, result);
  return result;
}

/// The first face of each part.
inline std::vector<int> first_faces(const PolygonMesh& mesh, const Components& surface) {
  std::vector<int> result(surface.parts.size(), -1);
  for (int f = mesh.face_count(); f-- > 0;)
    if (!mesh.face(f).empty() && surface.of(mesh.face(f)[0]) >= 0)
      result[static_cast<std::size_t>(surface.of(mesh.face(f)[0]))] = f;
  return result;
}

/// For each part its triangle that looks largest from above.
inline std::vector<std::array<int, 3>> widest_triangles(const PolygonMesh& mesh,
                                                        const Components& surface) {
  std::vector<std::array<int, 3>> widest(surface.parts.size());
  std::vector<double> area(surface.parts.size(), -1);
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    if (surface.of(t[0]) < 0) return;
    const auto i = static_cast<std::size_t>(surface.of(t[0]));
    const Vec3& a = mesh.vertex(t[0]);
    const double seen = std::abs((mesh.vertex(t[1]) - a).cross(mesh.vertex(t[2]) - a).z());
    if (!(seen > area[i])) return;
    area[i] = seen;
    widest[i] = t;
  });
  return widest;
}

}  // namespace tumble
