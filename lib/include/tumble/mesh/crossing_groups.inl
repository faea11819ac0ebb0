#pragma once

#include "tumble/mesh/crossing_groups.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY CrossingGroups::CrossingGroups(const PolygonMesh& mesh, const Components& surface,
                                           const TriangleMeetings& meetings) {
  using Parts = std::pair<int, int>;
  std::map<Parts, TriangleMeetings> groups;
  const auto parts_of = [&](const TriangleMeeting& meeting) {
    return Parts(std::minmax(surface.of(mesh.face(meeting.faces[0])[0]),
                             surface.of(mesh.face(meeting.faces[1])[0])));
  };
  for (const TriangleMeeting& meeting : meetings.through)
    groups[parts_of(meeting)].through.push_back(meeting);
  for (const TriangleMeeting& meeting : meetings.touching)
    groups[parts_of(meeting)].touching.push_back(meeting);

  struct Group {
    Parts parts;
    double size;  // −1: nothing passes through anything
    TriangleMeetings meetings;
  };
  std::vector<Group> sorted;
  for (auto& [parts, own] : groups) {
    Eigen::AlignedBox3d box;
    for (const TriangleMeeting& meeting : own.through) box.extend(meeting.crossing.place);
    const double size = box.isEmpty() ? -1 : box.diagonal().norm();
    sorted.push_back({parts, size, std::move(own)});
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Group& a, const Group& b) { return a.size > b.size; });
  for (Group& group : sorted) {
    of_parts_[group.parts] = list_.size();
    of_part_.emplace(group.parts.first, list_.size());
    of_part_.emplace(group.parts.second, list_.size());
    list_.push_back(std::move(group.meetings));
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
