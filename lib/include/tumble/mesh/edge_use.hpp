#pragma once
/// @file
/// An edge as a face has it.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "tumble/mesh/mesh_defect.hpp"

namespace tumble::detail {

/// One use of an edge by a face.
struct EdgeUse {
  int low, high;  ///< its vertices, low < high
  int face;
  bool forward;  ///< the face goes from low to high

  bool same_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

/// Calls `visit(uses of one edge)` for every edge.
/// @param uses those of the same edge side by side
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, const Visit& visit) {
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    while (j < uses.size() && uses[i].same_edge(uses[j])) ++j;
    visit(std::span<const EdgeUse>(uses).subspan(i, j - i));
  }
}

/// "edge #3–#7, from vertex #3 at (…) to vertex #7 at (…)".
inline std::string describe_edge(const PolygonMesh& mesh, const EdgeUse& use) {
  return "the edge from " + describe_vertex(mesh, use.low) + " to " +
         describe_vertex(mesh, use.high);
}

}  // namespace tumble::detail
