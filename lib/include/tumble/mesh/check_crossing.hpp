#pragma once
/// @file
/// Parts that are inside out or lie wrongly in others, and places where the surface passes through
/// itself, with what they cost: as lines along the three axes see them. In words.

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "tumble/mesh/coordinate_rounding.hpp"
#include "tumble/mesh/crossing_size.hpp"
#include "tumble/mesh/mesh_defect.hpp"

namespace tumble::detail {

/// "going up the line x = 1, y = 2", or along another axis.
std::string describe_line(const LineHit& hit);

/// What a wrong depth looks like to somebody who goes along the line.
std::string describe_wrong_depth(const WrongDepth& wrong);

/// "; 1.6e-04 ± 2e-05 of the volume count wrongly".
std::string describe_share(double share, double uncertainty);

/// The piece of a line where the depth is wrong for longest; null if `counts` lets none pass.
template <class Counts>
const WrongDepth* longest_of(const std::vector<WrongDepth>& all, const Counts& counts) {
  const WrongDepth* longest = nullptr;
  for (const WrongDepth& wrong : all)
    if (counts(wrong) && (longest == nullptr || wrong.length > longest->length)) longest = &wrong;
  return longest;
}

/// All pieces of the lines of a bundle where the depth is wrong.
std::vector<WrongDepth> all_wrong_depths(const LineBundle& bundle);

/// "faces #3 and #40 pass through each other at about (1, 2, 3)".
std::string describe_meeting(const TriangleMeeting& meeting);

/// What lines along the axes, and pairs of triangles if they are looked for, are asked about.
struct CrossingQuestion {
  const PolygonMesh& mesh;
  const Components& surface;
  const Eigen::AlignedBox3d& box;  ///< around all vertices
  const LineLattices& lattices;
  const TrianglesNearLines& near;  ///< triangles that may meet a line of the lattices
  bool also_touching;              ///< whether places where triangles only touch are looked at
  std::optional<double> rounding;  ///< of the coordinates, as they were written [m], if it is known

  LineBundle hits(double blur) const {
    return hits_of_bundle(mesh, surface, box, lattices, near, blur);
  }
  double volume() const {
    double sum = 0;
    for (const Component& part : surface.parts) sum += part.volume;
    return std::abs(sum);
  }
  double written() const { return rounding ? *rounding : coordinate_rounding(mesh); }
};

/// The finding of a crossing that is there: what it looks like, and its share.
/// @param longest the longest piece of a line with a wrong depth, or null
MeshDefect crossing_defect(const CrossingQuestion& of, const CrossingEvidence& evidence,
                           const WrongDepth* longest, const WrongVolume& found);

/// Which parts are inside out or nested wrongly, and how much counts wrongly because the surface
/// crosses itself.
/// @param bundle its lines, with this blur
/// @param blur   overlaps that rounding by this much can cause are not crossings [m]
std::vector<MeshDefect> find_wrong_depth(const CrossingQuestion& of, TriangleMeetings meetings,
                                         const LineBundle& bundle, double blur);

/// The share that may pass as rounding.
/// @param written how far coordinates were rounded when they were written [m]
inline double excused_share(const CrossingQuestion& of, double written) {
  constexpr double of_floats = 0x1p-24;  // of the largest coordinate, at most
  const bool fine = written <= of_floats * largest_coordinate(of.box);
  return fine && !may_be_chosen(of.mesh.vertices) ? rounding_share_of_floats : rounding_share;
}

/// Whether a surface crosses itself by more than some share.
inline bool counts_too_much(const std::vector<MeshDefect>& findings, double share) {
  return std::any_of(findings.begin(), findings.end(),
                     [=](const MeshDefect& finding) { return finding.share > share; });
}

/// The longest piece of a line where the depth is wrong all along [m].
double longest_run(const LineHits& hits);

/// Lines along an axis that look closely at pieces of others where the depth is wrong: one through
/// each piece, and many all round.
LineList lines_around(const std::vector<WrongDepth>& wrong, const View& view,
                      const Eigen::AlignedBox3d& box);

/// Whether all pieces lie in layers that are thin along one axis. A line that runs *in* a layer
/// sees its whole width, so rounding of heights along the line does not explain what it sees.
/// @param thickness of the layers at most [m]
bool is_in_thin_layers(const CrossingQuestion& of, const std::vector<WrongDepth>& wrong,
                       double thickness);

/// Whether all that was found are crossings of a known share.
bool only_crosses(const std::vector<MeshDefect>& findings);

/// Whether no triangles lie deeper in each other than rounding explains: lines may have missed
/// them.
bool none_deeper(TriangleMeetings meetings, double blur);

/// The crossings of a known share, as notes.
std::vector<MeshDefect> as_rounding(const std::vector<MeshDefect>& findings);

/// The same; what rounding of the file's last decimal may have done is a note, as long as it counts
/// little. A body far away, or one that was written with few digits, may lose much by it.
/// @param lines that were drawn with the rounding of doubles
std::vector<MeshDefect> find_wrong_depth(const CrossingQuestion& of,
                                         const TriangleMeetings& meetings, const LineBundle& lines);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/check_crossing.inl"
#endif
