#pragma once
/// @file
/// How much of its volume does a surface that crosses itself count wrongly?

#include <algorithm>
#include <cmath>
#include <vector>

#include "tumble/mesh/crossing_cells.hpp"
#include "tumble/mesh/crossing_groups.hpp"
#include "tumble/mesh/crossing_pairs.hpp"
#include "tumble/mesh/searched_mesh.hpp"

namespace tumble::detail {

/// The box around the places where triangles pass through each other, with as much again around it:
/// a crossing that no line has met is looked for there.
Eigen::AlignedBox3d box_around(const std::vector<TriangleMeeting>& meetings);

/// What is known of a crossing before its size is.
struct CrossingEvidence {
  const LineBundle& bundle;              ///< the lines that were drawn first
  const std::vector<WrongDepth>& wrong;  ///< where the depth on them is wrong
  const TriangleMeetings& meetings;      ///< where triangles meet, as far as that was looked for

  /// Whether any of the lines met a crossing.
  template <class Counts>
  bool is_seen(const Counts& counts) const {
    return std::any_of(wrong.begin(), wrong.end(), counts);
  }
};

/// The box around what is known of a crossing, with two spacings of the lines around it: those
/// beside the lines that met it did not.
/// @param box around the parts that have it
template <class Counts>
Eigen::AlignedBox3d box_around(const CrossingEvidence& evidence, const Eigen::AlignedBox3d& box,
                               const Counts& counts) {
  constexpr double spacings = 2.0 / 64;  // of some thousand lines
  Eigen::AlignedBox3d known;
  for (const WrongDepth& wrong : evidence.wrong) {
    if (!counts(wrong)) continue;
    known.extend(wrong.place(0));
    known.extend(wrong.place(1));
  }
  for (const TriangleMeeting& meeting : evidence.meetings.through)
    known.extend(meeting.crossing.place);
  const Vec3 margin =
      (spacings * box.sizes()).cwiseMax(Vec3::Constant(known.sizes().maxCoeff() / 2));
  return {known.min() - margin, known.max() + margin};
}

/// The box around the parts that cross themselves or each other: of an assembly it is a piece.
template <class Counts>
Eigen::AlignedBox3d box_of_parts(const SearchedMesh& on, const CrossingEvidence& evidence,
                                 const Counts& counts) {
  Eigen::AlignedBox3d box;
  const auto extend = [&](int part) {
    if (part >= 0) box.extend(on.box_of_part(part));
  };
  for (const WrongDepth& wrong : evidence.wrong) {
    if (!counts(wrong)) continue;
    extend(wrong.here.part);
    extend(wrong.before.part);
  }
  for (const auto* list : {&evidence.meetings.through, &evidence.meetings.touching})
    for (const TriangleMeeting& meeting : *list)
      for (const int face : meeting.faces) extend(on.part_of_face(face));
  return box;
}

/// What lines along the axes are drawn for.
template <class Counts>
struct CrossingLines {
  SearchedMesh& on;
  const CrossingEvidence& evidence;
  const Counts& counts;  ///< counts(WrongDepth): whether a piece of a line belongs to the crossing

  /// The volume that counts wrongly in a box that is cut into cells: the most that is seen along
  /// any axis, because a crossing that is not seen along one is not measured there.
  WrongVolume volume_in(const Eigen::AlignedBox3d& where, double cell_count) const {
    constexpr std::size_t enough = 200;  // lines that found it: 2 σ is a seventh
    WrongVolume largest;
    for (int axis = 0; axis < 3; ++axis) {
      const View view{axis};
      const LineHits& hits = evidence.bundle.along[static_cast<std::size_t>(axis)];
      CrossingCells cells(on, view, where, cell_count, counts);
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
          seen < enough ? cells.measure() : volume_by_lattice(hits, view.box(on.box()), counts);
      const bool nothing = found.volume == 0 && largest.volume == 0;
      if (axis == 0 || found.volume > largest.volume ||
          (nothing && found.uncertainty < largest.uncertainty))
        largest = found;
    }
    return largest;
  }
};

/// An estimate, not a bound, of what counts wrongly where triangles pass through each other, but no
/// line has seen it: as deep as the deepest two triangles lie in each other, on the whole surface.
/// Two bodies may lie deeper in each other than their triangles do.
inline double most_unseen(const SearchedMesh& on, const std::vector<TriangleMeeting>& through) {
  double deepest = 0, area = 0;
  for (const TriangleMeeting& meeting : through)
    deepest = std::max(deepest, meeting.crossing.depth);
  for (const Component& part : on.surface().parts) area += part.area;
  return deepest * area;
}

/// The volume that counts wrongly at one crossing. Where a crossing is so small that few lines met
/// it, all lines are drawn near it.
/// @param counts counts(WrongDepth): whether a piece of a line belongs to the crossing
template <class Counts>
WrongVolume wrong_volume_at(SearchedMesh& on, const CrossingEvidence& evidence,
                            const Counts& counts) {
  const CrossingLines<Counts> lines{on, evidence, counts};
  const bool met = evidence.is_seen(counts), through = !evidence.meetings.through.empty();
  if (!met && through) {
    WrongVolume near = lines.volume_in(box_around(evidence.meetings.through), 256);
    if (near.volume == 0)
      near.uncertainty = std::min(near.uncertainty, most_unseen(on, evidence.meetings.through));
    return near;
  }
  const Eigen::AlignedBox3d parts = box_of_parts(on, evidence, counts);
  const WrongVolume found = lines.volume_in(parts, 4096);
  if (!met || found.uncertainty < found.volume / 2) return found;
  const WrongVolume closer = lines.volume_in(box_around(evidence, parts, counts), 4096);
  const bool better =
      closer.volume > 0 && closer.uncertainty * found.volume <= found.uncertainty * closer.volume;
  return better ? closer : found;
}

/// The volume that counts wrongly at all crossings: those that are apart are measured one by one,
/// because a box around all of them has cells that are larger than they are.
template <class Counts>
WrongVolume wrong_volume(SearchedMesh& on, const CrossingEvidence& evidence, const Counts& counts) {
  const CrossingGroups groups(on.mesh(), on.surface(), evidence.meetings);
  const std::size_t number = groups.list().size();
  if (number < 2) return wrong_volume_at(on, evidence, counts);
  const auto measure = [&](std::size_t k) -> WrongVolume {
    const auto belongs = [&groups, &counts, k](const WrongDepth& wrong) {
      return groups.owner(wrong) == k && counts(wrong);
    };
    const TriangleMeetings none;
    const CrossingEvidence own{evidence.bundle, evidence.wrong,
                               k < number ? groups.list()[k] : none};
    if (k == number && !own.is_seen(belongs)) return {};
    const WrongVolume found = wrong_volume_at(on, own, belongs);
    const bool only_touch = found.volume == 0 && own.meetings.through.empty();
    return only_touch ? WrongVolume{} : found;
  };
  const WrongVolume known = sum_over_crossings(number, on.mesh().face_count(), measure),
                    others = measure(number);
  return {known.volume + others.volume, std::hypot(known.uncertainty, others.uncertainty)};
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/crossing_size.inl"
#endif
