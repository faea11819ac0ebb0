#pragma once
/// @file
/// What a reader is told of a mesh that is a body all the same.

#include <string>
#include <vector>

#include "support/printable.hpp"
#include "tumble/mesh/diagnose.hpp"

namespace tumble::support {

/// A sentence for each thing that was done to a mesh, or found in it.
/// @param welded how many vertices no face has any more: see detail::weld_if_open()
inline std::vector<std::string> mesh_notes(int welded, const std::vector<MeshDefect>& findings) {
  std::vector<std::string> all;
  if (welded > 0)
    all.push_back("welded: we take " + std::to_string(welded) +
                  " vertices for earlier ones at exactly the same place, so that faces that meet "
                  "share their edges");
  for (const MeshDefect& finding : findings)
    all.push_back(std::string(name_of(finding.kind)) + ": " + escaped(finding.message));
  return all;
}

}  // namespace tumble::support
