#pragma once

#include "tumble/mesh/doubled_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "tumble/core/compiled.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/mesh/check_edges.hpp"
#include "tumble/mesh/closed_pieces.hpp"
#include "tumble/mesh/coordinate_rounding.hpp"
#include "tumble/mesh/line_bundle.hpp"
#include "tumble/mesh/weld.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<char> possible_copies(const std::vector<Component>& parts, double by) {
  std::array<std::vector<double>, 2> sizes;  // of the parts that look outwards, and inwards
  for (const Component& part : parts) sizes[part.volume < 0].push_back(std::abs(part.volume));
  for (std::vector<double>& list : sizes) std::sort(list.begin(), list.end());
  std::vector<char> possible;
  for (const Component& part : parts) {
    const std::vector<double>& others = sizes[!(part.volume < 0)];
    const double size = std::abs(part.volume);
    const double slack = 2 * (2 * by * part.area + part.rounding);  // of two as large surfaces
    const auto other = std::lower_bound(others.begin(), others.end(), size - slack);
    possible.push_back(is_rounding(part, by) || (other != others.end() && *other <= size + slack));
  }
  return possible;
}

TUMBLE_BODY std::vector<char> most_edges_are_shared_by_four(const PolygonMesh& mesh,
                                                            const Components& surface) {
  std::vector<std::size_t> all(surface.parts.size()), shared(surface.parts.size());
  for_each_edge(edge_uses(mesh), [&](std::span<const EdgeUse> edge) {
    const auto part = static_cast<std::size_t>(surface.of(edge[0].low));
    all[part] += edge.size();
    if (edge.size() >= 4) shared[part] += edge.size();
  });
  std::vector<char> result;
  for (std::size_t i = 0; i < all.size(); ++i) result.push_back(3 * shared[i] > all[i]);
  return result;
}

TUMBLE_BODY std::string describe_doubled(int face, double volume, double written) {
  std::ostringstream text;
  text.precision(3);
  text << "the faces ";
  if (face >= 0) text << "of the part with face #" << face + 1 << " ";
  text << "are all there twice, once each way round. They enclose " << volume
       << " m³, no more than rounding to " << written
       << " m may make of nothing: take one face of each two away";
  return text.str();
}

TUMBLE_BODY std::vector<char> doubled_parts(const PolygonMesh& mesh, const Components& surface,
                                            double written) {
  std::vector<char> doubled = most_edges_are_shared_by_four(mesh, surface);
  for (std::size_t i = 0; i < doubled.size(); ++i)
    doubled[i] = doubled[i] && is_rounding(surface.parts[i], written);
  return doubled;
}

TUMBLE_BODY std::vector<MeshDefect> find_doubled_among(const PolygonMesh& whole,
                                                       const SomeFaces& some, double written) {
  const PolygonMesh mesh = apart_at_pinches(weld(some.mesh));
  const Components surface = components(mesh, enclosed_by(mesh));
  const std::vector<char> doubled = doubled_parts(mesh, surface, written);
  if (std::find(doubled.begin(), doubled.end(), 1) == doubled.end()) return {};
  std::vector<char> left_out(static_cast<std::size_t>(whole.face_count()), 0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int part = surface.of(mesh.face(f)[0]);
    left_out[static_cast<std::size_t>(some.numbers[static_cast<std::size_t>(f)])] =
        part >= 0 && doubled[static_cast<std::size_t>(part)];
  }
  const SomeFaces rest(whole, [&](int f) { return !left_out[static_cast<std::size_t>(f)]; });
  const std::vector<char> inside = inside_of(rest.mesh, places_on_parts(mesh, surface));
  const bool alone = rest.mesh.face_count() == 0 && doubled.size() == 1;
  const std::vector<int> faces = first_faces(mesh, surface);
  MeshDefectsOfOneKind found(MeshDefectKind::flat);
  for (std::size_t i = 0; i < doubled.size(); ++i) {
    if (!doubled[i] || inside[i]) continue;
    const int face = some.numbers[static_cast<std::size_t>(faces[i])];
    found.add(face, {-1, -1}, [&] {
      return describe_doubled(alone ? -1 : face, surface.parts[i].volume, written);
    });
  }
  std::vector<MeshDefect> findings;
  found.append_to(findings);
  return findings;
}

TUMBLE_BODY std::vector<MeshDefect> find_doubled_surfaces(const PolygonMesh& mesh,
                                                          const Components& surface,
                                                          const Eigen::AlignedBox3d& box,
                                                          std::optional<double> rounding) {
  constexpr double coarsest = 5e-3;  // of what coordinate_rounding() gives
  const double largest = largest_coordinate(box);
  const auto possible = [&](double by) { return possible_copies(surface.parts, by); };
  const auto any = [](const std::vector<char>& list) {
    return std::find(list.begin(), list.end(), 1) != list.end();
  };
  if (!any(possible(std::max(coarsest * largest, rounding.value_or(0))))) return {};
  const double written =
      std::max(rounding ? *rounding : coordinate_rounding(mesh), unit_roundoff * largest);
  const std::vector<char> copies = possible(written);
  if (!any(copies)) return {};
  const SomeFaces some(mesh, [&](int f) {
    const int part = surface.of(mesh.face(f)[0]);
    return part >= 0 && copies[static_cast<std::size_t>(part)];
  });
  return find_doubled_among(mesh, some, written);
}

}  // namespace tumble::detail
