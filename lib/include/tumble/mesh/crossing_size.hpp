#pragma once
/// @file
/// How much of its volume does a surface that crosses itself count wrongly?

#include "tumble/mesh/crossing_cells.hpp"
#include "tumble/mesh/crossing_pairs.hpp"

namespace tumble::detail {

/// The box around the places where triangles pass through each other, with as much again around it:
/// a crossing that no line has met is looked for there.
inline Eigen::AlignedBox3d box_around(const std::vector<TriangleMeeting>& meetings) {
  Eigen::AlignedBox3d box;
  for (const TriangleMeeting& meeting : meetings) box.extend(meeting.crossing.place);
  const double margin = box.sizes().maxCoeff() / 2;
  return {box.min() - Vec3::Constant(margin), box.max() + Vec3::Constant(margin)};
}

/// What is known of a crossing before its size is.
struct CrossingEvidence {
  LineBundle bundle;          ///< the lines that were drawn first
  bool is_seen;               ///< whether any of them has a wrong depth
  TriangleMeetings meetings;  ///< places where triangles meet, if they were looked for
};

/// The volume that counts wrongly: the most that is seen along any axis, because a crossing that is
/// not seen along one is not measured there.
/// @param counts counts(WrongDepth): whether a piece of a line belongs to the crossing
template <class Counts>
WrongVolume wrong_volume(const PolygonMesh& mesh, const Components& surface,
                         const Eigen::AlignedBox3d& box, const CrossingEvidence& evidence,
                         double blur, const Counts& counts) {
  constexpr std::size_t enough = 200;  // lines that found it: 2 σ is a seventh
  const bool zoom = !evidence.is_seen && !evidence.meetings.through.empty();
  const Eigen::AlignedBox3d where = zoom ? box_around(evidence.meetings.through) : box;
  WrongVolume largest;
  for (int axis = 0; axis < 3; ++axis) {
    const View view{axis};
    const LineHits& hits = evidence.bundle.along[static_cast<std::size_t>(axis)];
    CrossingCells cells(LinesOnMesh{mesh, surface, view, blur}, where, zoom ? 256 : 4096, counts);
    std::size_t seen = 0;
    const auto begin_at = [&](const LineHits& lines) {
      for (const WrongDepth& wrong : find_wrong_depths(lines)) {
        if (!counts(wrong)) continue;
        cells.begin_at(wrong.here.line);
        ++seen;
      }
    };
    begin_at(hits);
    if (axis == 2) begin_at(evidence.bundle.through_parts);
    for (const auto* list : {&evidence.meetings.through, &evidence.meetings.touching})
      for (const TriangleMeeting& meeting : *list)
        cells.begin_at(view.point(meeting.crossing.place).head<2>());
    const WrongVolume found =
        seen < enough ? cells.measure() : volume_by_lattice(hits, view.box(box), counts);
    if (found.volume > largest.volume) largest = found;
  }
  return largest;
}

}  // namespace tumble::detail
