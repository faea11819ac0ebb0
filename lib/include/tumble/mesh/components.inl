#pragma once

#include "tumble/mesh/components.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::detail {

TUMBLE_BODY Components label_components(const PolygonMesh& mesh) {
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

TUMBLE_BODY std::vector<EnclosedVolume> enclosed_by_parts(const PolygonMesh& mesh,
                                                          const Components& surface) {
  std::vector<EnclosedVolume> result(surface.parts.size());
  const auto point = [&](int v) -> simd::Point<double> {
    return {mesh.vertex(v).x(), mesh.vertex(v).y(), mesh.vertex(v).z()};
  };
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const int part = surface.of(t[0]);
    if (part < 0) return;  // three times a vertex that nothing else uses
    const auto i = static_cast<std::size_t>(part);
    const VolumeTerms<double> terms(point(t[0]), point(t[1]), point(t[2]),
                                    point(surface.parts[i].a_vertex));
    result[i] += {terms.six_volume, terms.magnitude, terms.twice_area, terms.doubtful};
  });
  return result;
}

TUMBLE_BODY void measure_thin_parts(const PolygonMesh& mesh, Components& surface) {
  std::vector<simd::DoubleDouble> six_volume(surface.parts.size());
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

TUMBLE_BODY Components components(const PolygonMesh& mesh, const EnclosedVolume& all) {
  Components result = label_components(mesh);
  const std::vector<EnclosedVolume> enclosed =
      result.parts.size() == 1 ? std::vector{all} : enclosed_by_parts(mesh, result);
  // A term has 8 roundings at most; those of the sum grow like √n when they fall at random.
  const double roundings = 8 + std::sqrt(static_cast<double>(mesh.corners.size()));
  for (std::size_t i = 0; i < enclosed.size(); ++i) {
    result.parts[i].volume = enclosed[i].six_volume / 6;
    result.parts[i].rounding = enclosed[i].magnitude * roundings * unit_roundoff / 6;
    result.parts[i].area = enclosed[i].twice_area / 2;
  }
  measure_thin_parts(mesh, result);
  return result;
}

TUMBLE_BODY std::vector<int> first_faces(const PolygonMesh& mesh, const Components& surface) {
  std::vector<int> result(surface.parts.size(), -1);
  for (int f = mesh.face_count(); f-- > 0;)
    if (!mesh.face(f).empty() && surface.of(mesh.face(f)[0]) >= 0)
      result[static_cast<std::size_t>(surface.of(mesh.face(f)[0]))] = f;
  return result;
}

TUMBLE_BODY std::vector<std::array<int, 3>> widest_triangles(const PolygonMesh& mesh,
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

}  // namespace tumble::detail
