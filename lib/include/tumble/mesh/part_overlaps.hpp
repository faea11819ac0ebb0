#pragma once
/// @file
/// The triangles of an assembly that are worth a look pair by pair, whatever their number: those
/// that lie in the box of another part, which are few, and those of parts that are so small in the
/// box of the whole that lines over it hardly meet them.

#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/crossing_pairs.hpp"

namespace tumble::detail {

/// The box around each part; `face` is the number of the part.
std::vector<BoxedTriangle> boxed_parts(const PolygonMesh& mesh, const Components& surface);

/// For each part where its box meets those of others; empty if there are too many to look at.
/// @param most that a part may have, and that a part may have on average in its cells of a grid
std::vector<std::vector<Eigen::AlignedBox3d>> overlaps_of_parts(const PolygonMesh& mesh,
                                                                const Components& surface,
                                                                std::size_t most);

/// For each part whether lines over the whole box, which may be far larger, hardly meet it.
/// @param share of the lines along one of the axes at least that see enough of a part
std::vector<char> hardly_seen_parts(const PolygonMesh& mesh, const Components& surface,
                                    const Eigen::AlignedBox3d& whole, double share);

/// The triangles that lie in boxes of other parts; none if they are more than `most`.
/// @param few boxes of others that a part is looked at with
std::vector<BoxedTriangle> triangles_near_other_parts(const PolygonMesh& mesh,
                                                      const Components& surface, std::size_t most,
                                                      std::size_t few);

/// The triangles of each of the parts that are wanted; of the others none.
std::vector<std::vector<BoxedTriangle>> triangles_of_parts(const PolygonMesh& mesh,
                                                           const Components& surface,
                                                           const std::vector<char>& wanted);

/// Where triangles meet that have no edge in common: near other parts, and in parts that lines
/// hardly meet, each by itself.
/// @param hidden which parts lines hardly meet
TriangleMeetings meetings_of_parts(const PolygonMesh& mesh, const Components& surface,
                                   const std::vector<char>& hidden, std::size_t most,
                                   std::size_t few);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/part_overlaps.inl"
#endif
