#pragma once

#include "tumble/mesh/weld.hpp"

#include <algorithm>
#include <numeric>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<int> first_at_same_position(const PolygonMesh& mesh) {
  std::vector<int> by_position(mesh.vertices.size()), first(mesh.vertices.size());
  std::iota(by_position.begin(), by_position.end(), 0);
  std::sort(by_position.begin(), by_position.end(), [&](int i, int j) {
    const Vec3 &a = mesh.vertex(i), &b = mesh.vertex(j);
    for (int k = 0; k < 3; ++k)
      if (a[k] != b[k]) return a[k] < b[k];
    return i < j;
  });
  // The first of each run of equal positions speaks for the run.
  int speaker = 0;
  for (std::size_t k = 0; k < by_position.size(); ++k) {
    const int i = by_position[k];
    if (k == 0 || mesh.vertex(speaker) != mesh.vertex(i)) speaker = i;
    first[static_cast<std::size_t>(i)] = speaker;
  }
  return first;
}

}  // namespace tumble::detail

namespace tumble {

TUMBLE_BODY PolygonMesh weld(const PolygonMesh& mesh) {
  const std::vector<int> first = detail::first_at_same_position(mesh);
  PolygonMesh welded;
  std::vector<int> new_index(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto speaker = static_cast<std::size_t>(first[i]);
    if (speaker == i) welded.vertices.push_back(mesh.vertices[i]);
    new_index[i] = speaker == i ? static_cast<int>(welded.vertices.size()) - 1 : new_index[speaker];
  }
  welded.first_corner = mesh.first_corner;
  welded.corners.reserve(mesh.corners.size());
  for (const int v : mesh.corners) welded.corners.push_back(new_index[static_cast<std::size_t>(v)]);
  return welded;
}

}  // namespace tumble
