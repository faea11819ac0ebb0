#pragma once
/// @file
/// The parts of a closed surface: which enclose nothing, which are inside out, which lie in another
/// and count twice. In words.

#include <string>
#include <vector>

#include "tumble/mesh/depth.hpp"
#include "tumble/mesh/mesh_defect.hpp"

namespace tumble::detail {

/// "the part with face #13 (12 of 24 faces)", or "the surface" when it has one part only.
std::string describe_part(const PolygonMesh& mesh, const Components& surface, int face);

/// For each part whether it has a face with an area.
std::vector<char> parts_with_area(const PolygonMesh& mesh, const Components& surface);

/// For each part whether it encloses nothing that could be told from 0.
std::vector<char> flat_parts(const Components& surface);

/// Finds the parts of a closed surface that enclose nothing. Faces without an area that lie beside
/// a body are no part of it, and are named already. What lies in the inside of a body, as a cavity
/// does that another body fills, takes nothing away: it counts as a share of 0.
std::vector<MeshDefect> find_flat_parts(const PolygonMesh& mesh, const Components& surface);

/// Whether a part lies in others and looks outwards.
inline bool is_nested_wrongly(const Component& part, const PartDepth& depth) {
  return depth.least_around == depth.most_around && depth.least_around > 0 &&
         part.volume > part.rounding;
}

/// How far rounding may have moved what lies in others: `blur`, unless what it excuses counts for
/// too much, all of it together.
double excused_blur(const Components& surface, const std::vector<PartDepth>& depths, double blur);

/// Says of each part whether it is inverted or nested wrongly, as `depths` tell.
/// @param blur what encloses no more in a body than rounding by so much may have made of nothing is
///             not nested in it [m]
std::vector<MeshDefect> find_wrong_parts(const PolygonMesh& mesh, const Components& surface,
                                         const std::vector<PartDepth>& depths, double blur);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/check_parts.inl"
#endif
