#pragma once
/// @file
/// A mesh whose file has its lengths in millimetres, centimetres or inches.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "tumble/mesh/coordinate_rounding.hpp"
#include "tumble/mesh/labelled_mesh.hpp"
#include "tumble/mesh/mesh_defect.hpp"
#include "tumble/mesh/read_mesh.hpp"

namespace tumble::scenes {

/// A length in metres: rounded once more, so what counts decimals asks the numbers of the file.
template <class Length>
Length in_metres(const Length& x, const std::string& unit) {
  if (unit == "mm") return x / 1000;
  if (unit == "cm") return x / 100;
  if (unit == "in") return x * 0.0254;
  return x;
}

/// A mesh with lengths in metres, which knows how they were written.
struct ReadMesh {
  parts::LabelledMesh mesh;
  std::vector<Vec3> as_written;  ///< the vertices in the unit of the file, if it is not the metre

  ReadMesh(const std::string& file, const std::string& unit) : mesh(read_mesh(file)) {
    if (unit == "m") return;
    as_written = mesh.vertices;
    for (Vec3& p : mesh.vertices) p = in_metres<Vec3>(p, unit);
  }
};

/// What `diagnosed` finds if it is told how far coordinates were rounded when they were written. In
/// metres they have more digits than in the file: where something crosses, the file is asked.
template <class Diagnosed>
std::vector<MeshDefect> findings_of(const ReadMesh& read, const std::string& unit,
                                    const Diagnosed& diagnosed) {
  std::vector<MeshDefect> findings = diagnosed(std::optional<double>{});
  const bool crosses = std::any_of(findings.begin(), findings.end(), [](const MeshDefect& finding) {
    return finding.kind == MeshDefectKind::self_crossing ||
           finding.kind == MeshDefectKind::nested_wrong;
  });
  if (!crosses || read.as_written.empty()) return findings;
  return diagnosed(std::optional(in_metres(detail::coordinate_rounding(read.as_written), unit)));
}

}  // namespace tumble::scenes
