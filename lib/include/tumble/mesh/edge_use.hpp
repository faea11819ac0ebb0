#pragma once
/// @file
/// An edge as a face has it.

#include <string>

#include "tumble/mesh/mesh_defect.hpp"

namespace tumble::detail {

/// One use of an edge by a face.
struct EdgeUse {
  int low, high;  ///< its vertices, low < high
  int face;
  bool forward;  ///< the face goes from low to high

  bool same_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

/// "edge #3–#7, from vertex #3 at (…) to vertex #7 at (…)".
inline std::string describe_edge(const PolygonMesh& mesh, const EdgeUse& use) {
  return "the edge from " + describe_vertex(mesh, use.low) + " to " +
         describe_vertex(mesh, use.high);
}

}  // namespace tumble::detail
