#pragma once

#include "tumble/mesh/crossing_groups.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/part_overlaps.hpp"

namespace tumble::detail {

/// Two parts, or one twice, and where triangles of them meet.
struct PairOfParts {
  std::pair<int, int> parts;
  TriangleMeetings meetings;
  Eigen::AlignedBox3d common;  ///< of their boxes

  bool crosses() const { return !meetings.through.empty(); }
};

TUMBLE_BODY std::vector<PairOfParts> pairs_that_meet(const PolygonMesh& mesh,
                                                     const Components& surface,
                                                     const TriangleMeetings& meetings) {
  std::map<std::pair<int, int>, TriangleMeetings> pairs;
  const auto of = [&](const TriangleMeeting& meeting) -> TriangleMeetings& {
    return pairs[std::minmax(surface.of(mesh.face(meeting.faces[0])[0]),
                             surface.of(mesh.face(meeting.faces[1])[0]))];
  };
  for (const TriangleMeeting& meeting : meetings.through) of(meeting).through.push_back(meeting);
  for (const TriangleMeeting& meeting : meetings.touching) of(meeting).touching.push_back(meeting);
  const std::vector<BoxedTriangle> boxes = boxed_parts(mesh, surface);
  const auto box_of = [&](int part) {
    return part < 0 ? Eigen::AlignedBox3d() : boxes[static_cast<std::size_t>(part)].box;
  };
  std::vector<PairOfParts> list;
  list.reserve(pairs.size());
  for (auto& [parts, own] : pairs)
    list.push_back({parts, std::move(own), box_of(parts.first).intersection(box_of(parts.second))});
  return list;
}

/// For each pair the first of its crossing: one are those whose common boxes meet, and all that
/// only touch.
TUMBLE_BODY std::vector<int> roots_of_crossings(const std::vector<PairOfParts>& pairs) {
  DisjointSets sets(pairs.size());
  const auto join = [&](std::size_t a, std::size_t b) {
    sets.join(static_cast<int>(a), static_cast<int>(b));
  };
  std::vector<std::size_t> by_x(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) by_x[k] = k;
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) {
    return pairs[a].common.min().x() < pairs[b].common.min().x();
  });
  std::size_t touching = pairs.size();
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const PairOfParts& one = pairs[by_x[i]];
    if (!one.crosses()) {
      if (touching == pairs.size()) touching = by_x[i];
      join(touching, by_x[i]);
      continue;
    }
    for (std::size_t j = i + 1; j < by_x.size(); ++j) {
      const PairOfParts& other = pairs[by_x[j]];
      if (other.common.min().x() > one.common.max().x()) break;
      if (other.crosses() && one.common.intersects(other.common)) join(by_x[i], by_x[j]);
    }
  }
  return sets.roots();
}

/// How large the crossing is that these places are on; −1 if nothing passes through anything.
TUMBLE_BODY double extent_of_crossing(const TriangleMeetings& meetings) {
  Eigen::AlignedBox3d box;
  for (const TriangleMeeting& meeting : meetings.through) box.extend(meeting.crossing.place);
  return box.isEmpty() ? -1 : box.diagonal().norm();
}

TUMBLE_BODY CrossingGroups::CrossingGroups(const PolygonMesh& mesh, const Components& surface,
                                           const TriangleMeetings& meetings) {
  const std::vector<PairOfParts> pairs = pairs_that_meet(mesh, surface, meetings);
  const std::vector<int> roots = roots_of_crossings(pairs);
  std::map<int, TriangleMeetings> groups;
  for (std::size_t k = 0; k < pairs.size(); ++k) groups[roots[k]].append(pairs[k].meetings);
  std::vector<std::pair<double, int>> order;  // size, root
  order.reserve(groups.size());
  for (const auto& [root, own] : groups) order.emplace_back(-extent_of_crossing(own), root);
  std::sort(order.begin(), order.end());
  std::map<int, std::size_t> place;
  for (const auto& [size, root] : order) {
    place[root] = list_.size();
    list_.push_back(std::move(groups[root]));
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const std::size_t own = place[roots[k]];
    of_parts_[pairs[k].parts] = own;
    of_part_.emplace(pairs[k].parts.first, own);
    of_part_.emplace(pairs[k].parts.second, own);
  }
}

TUMBLE_BODY std::size_t CrossingGroups::owner(const WrongDepth& wrong) const {
  const auto own = of_parts_.find(std::minmax(wrong.before.part, wrong.here.part));
  if (own != of_parts_.end()) return own->second;
  for (const int part : {wrong.here.part, wrong.before.part})
    if (const auto found = of_part_.find(part); found != of_part_.end()) return found->second;
  return list_.size();
}

}  // namespace tumble::detail
