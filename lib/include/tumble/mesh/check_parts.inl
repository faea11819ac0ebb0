#pragma once

#include "tumble/mesh/check_parts.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/inside_of.hpp"

namespace tumble::detail {

TUMBLE_BODY std::string describe_part(const PolygonMesh& mesh, const Components& surface,
                                      int face) {
  if (surface.parts.size() == 1) return "the surface";
  const int part = surface.of(mesh.face(face)[0]);
  int count = 0;
  for (int f = 0; f < mesh.face_count(); ++f)
    count += !mesh.face(f).empty() && surface.of(mesh.face(f)[0]) == part;
  return "the part with face #" + std::to_string(face + 1) + " (" + std::to_string(count) + " of " +
         std::to_string(mesh.face_count()) + " faces)";
}

TUMBLE_BODY std::vector<char> parts_with_area(const PolygonMesh& mesh, const Components& surface) {
  std::vector<char> result(surface.parts.size(), 0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int part = mesh.face(f).empty() ? -1 : surface.of(mesh.face(f)[0]);
    if (part < 0) continue;
    char& any = result[static_cast<std::size_t>(part)];
    any = any || !has_no_area(mesh, mesh.face(f));
  }
  return result;
}

TUMBLE_BODY std::vector<char> flat_parts(const Components& surface) {
  std::vector<char> flat;
  for (const Component& part : surface.parts)
    flat.push_back(!(std::abs(part.volume) > part.rounding));
  return flat;
}

TUMBLE_BODY std::vector<MeshDefect> find_flat_parts(const PolygonMesh& mesh,
                                                    const Components& surface) {
  const std::vector<char> is_flat = flat_parts(surface);
  if (std::find(is_flat.begin(), is_flat.end(), 1) == is_flat.end()) return {};
  const bool all_flat = std::find(is_flat.begin(), is_flat.end(), 0) == is_flat.end();
  const std::vector<char> with_area = parts_with_area(mesh, surface);
  const SomeFaces body(mesh, [&](int f) {
    const int part = surface.of(mesh.face(f)[0]);
    return part >= 0 && !is_flat[static_cast<std::size_t>(part)];
  });
  const std::vector<char> inside = inside_of(body.mesh, places_on_parts(mesh, surface));
  MeshDefectsOfOneKind flat(MeshDefectKind::flat), filled(MeshDefectKind::flat);
  const std::vector<int> faces = first_faces(mesh, surface);
  for (std::size_t i = 0; i < surface.parts.size(); ++i) {
    if (!is_flat[i] || (!all_flat && !with_area[i])) continue;
    (inside[i] ? filled : flat).add(faces[i], {-1, -1}, [&] {
      return describe_part(mesh, surface, faces[i]) +
             " encloses no volume that could be told from 0" +
             (inside[i] ? ", in the inside of a body: nothing counts wrongly" : "");
    });
  }
  std::vector<MeshDefect> findings;
  filled.append_to(findings);
  for (MeshDefect& finding : findings) finding.share = finding.share_uncertainty = 0;
  flat.append_to(findings);
  return findings;
}

TUMBLE_BODY double excused_blur(const Components& surface, const std::vector<PartDepth>& depths,
                                double blur) {
  double all = 0, excused = 0;
  for (std::size_t i = 0; i < surface.parts.size(); ++i) {
    const Component& part = surface.parts[i];
    all += part.volume;
    if (is_nested_wrongly(part, depths[i]) && is_rounding(part, blur))
      excused += depths[i].least_around * part.volume;
  }
  return excused > rounding_share * std::abs(all) ? 0 : blur;
}

TUMBLE_BODY std::vector<MeshDefect> find_wrong_parts(const PolygonMesh& mesh,
                                                     const Components& surface,
                                                     const std::vector<PartDepth>& depths,
                                                     double blur) {
  MeshDefectsOfOneKind inverted(MeshDefectKind::inverted), nested(MeshDefectKind::nested_wrong);
  const std::vector<int> faces = first_faces(mesh, surface);
  const double excused = excused_blur(surface, depths, blur);
  for (std::size_t i = 0; i < surface.parts.size(); ++i) {
    const Component& part = surface.parts[i];
    const PartDepth& depth = depths[i];
    if (depth.least_around != depth.most_around || !(std::abs(part.volume) > part.rounding))
      continue;
    std::ostringstream volume;
    volume << part.volume << " m³";
    if (part.volume < 0 && depth.least_around == 0)
      inverted.add(faces[i], {-1, -1}, [&] {
        return describe_part(mesh, surface, faces[i]) + " is inside out (volume " + volume.str() +
               "): reverse the corners of its faces";
      });
    if (is_nested_wrongly(part, depth) && !is_rounding(part, excused))
      nested.add(faces[i], {-1, -1}, [&] {
        return describe_part(mesh, surface, faces[i]) +
               " lies inside another part and looks outwards, so " + "that its " + volume.str() +
               " count " + std::to_string(depth.least_around + 1) +
               " times: reverse the corners of its faces if it is a cavity, else take it away";
      });
  }
  std::vector<MeshDefect> findings;
  inverted.append_to(findings);
  nested.append_to(findings);
  return findings;
}

}  // namespace tumble::detail
