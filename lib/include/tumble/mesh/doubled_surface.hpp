#pragma once
/// @file
/// Surfaces that are there twice, once each way round, as files for drawing have them.
///
/// If both copies are cut into the same triangles and share their vertices, nothing is left: the
/// surface is flat. If they are cut along other diagonals, as quads are whose fans begin at other
/// corners, what rounding has done to the corners is left between them: a volume of 10⁻¹⁶ of the
/// body's, known to all digits. If each copy has vertices of its own, it is a part that encloses a
/// body, and the other one takes the body away. A foil may be as thin, and a body may be as large
/// as a cavity, but few of their edges have more than two faces. Of a doubled polygon of n corners,
/// however it is cut, more than a third of the edges are its own, and have four.

#include <optional>
#include <string>
#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/inside_of.hpp"
#include "tumble/mesh/mesh_defect.hpp"

namespace tumble::detail {

/// Which parts may be copies of a surface that is there twice: those that enclose nothing, and
/// those that enclose what another one takes away.
std::vector<char> possible_copies(const std::vector<Component>& parts, double by);

/// For each part whether more than a third of its edges have four faces or more.
std::vector<char> most_edges_are_shared_by_four(const PolygonMesh& mesh, const Components& surface);

/// "the faces are all there twice …".
/// @param face of the part, or −1 if there is no other
std::string describe_doubled(int face, double volume, double written);

/// For each part of a surface whether it is there twice.
/// @param written how far coordinates were rounded [m]
std::vector<char> doubled_parts(const PolygonMesh& mesh, const Components& surface, double written);

/// Finds surfaces that are there twice, once each way round, among some faces of a closed mesh. In
/// the inside of a body they are a cavity that is filled.
/// @param some    whole parts
/// @param written how far its coordinates were rounded [m]
std::vector<MeshDefect> find_doubled_among(const PolygonMesh& whole, const SomeFaces& some,
                                           double written);

/// Finds parts of a closed surface that are there twice, once each way round.
/// @param surface  its parts; pieces that touch have to be apart (closed_pieces.hpp)
/// @param box      around all vertices
/// @param rounding of the coordinates, as they were written [m], if it is known
std::vector<MeshDefect> find_doubled_surfaces(const PolygonMesh& mesh, const Components& surface,
                                              const Eigen::AlignedBox3d& box,
                                              std::optional<double> rounding);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/doubled_surface.inl"
#endif
