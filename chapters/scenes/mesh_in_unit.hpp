#pragma once
/// @file
/// A mesh whose file has its lengths in millimetres, centimetres or inches.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "scenes/length_unit.hpp"
#include "tumble/mesh/coordinate_rounding.hpp"
#include "tumble/mesh/labelled_mesh.hpp"
#include "tumble/mesh/mesh_defect.hpp"
#include "tumble/mesh/read_mesh.hpp"
#include "tumble/mesh/weld_if_open.hpp"

namespace tumble::scenes {

/// A mesh as it was written, and in metres for what is said about it: rounded once more.
struct ReadMesh {
  LengthUnit unit;
  parts::LabelledMesh written;
  int welded = 0;  ///< how many vertices were taken for others at the same position
  std::optional<parts::LabelledMesh> converted = {};  ///< if the unit is not the metre

  /// @param solid whether the surface has to be closed
  ReadMesh(const std::string& file, const std::string& name, bool solid)
      : unit(length_unit(name)), written(read_mesh(file)) {
    if (solid) welded = detail::weld_if_open(written);
    if (name == "m") return;
    converted = written;
    for (Vec3& p : converted->vertices) p = unit.in_metres<Vec3>(p);
  }

  const parts::LabelledMesh& in_metres() const { return converted ? *converted : written; }
};

/// What `diagnosed` finds if it is told how far coordinates were rounded when they were written. In
/// metres they have more digits than in the file: where something crosses, the file is asked.
template <class Diagnosed>
std::vector<MeshDefect> findings_of(const ReadMesh& read, const Diagnosed& diagnosed) {
  std::vector<MeshDefect> findings = diagnosed(std::optional<double>{});
  const bool crosses = std::any_of(findings.begin(), findings.end(), [](const MeshDefect& finding) {
    return finding.kind == MeshDefectKind::self_crossing ||
           finding.kind == MeshDefectKind::nested_wrong;
  });
  if (!crosses || !read.converted) return findings;
  return diagnosed(std::optional(read.unit.in_metres(detail::coordinate_rounding(read.written))));
}

}  // namespace tumble::scenes
