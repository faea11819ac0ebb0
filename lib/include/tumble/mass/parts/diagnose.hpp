#pragma once
/// @file
/// What is wrong with the parts of a mesh, each by itself and all together, in words that name
/// them.

#include <cstdio>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tumble/mass/parts/renumbered.hpp"
#include "tumble/mass/parts/split.hpp"
#include "tumble/mesh/diagnose.hpp"

namespace tumble::detail {

inline int number_at(const std::vector<int>& numbers, int i) {
  return i < 0 ? i : numbers[static_cast<std::size_t>(i)];
}

/// A finding of a part's own mesh as one of the whole mesh.
MeshDefect in_the_whole(MeshDefect finding, const parts::Part& part);

/// The parts side by side, as if they shared no vertices: where they touch there is no edge of four
/// faces.
class SideBySide {
 public:
  explicit SideBySide(std::span<const parts::Part> parts) : parts_(parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const PolygonMesh& part = parts[i].mesh;
      const auto offset = static_cast<int>(mesh.vertices.size());
      const auto corners = static_cast<int>(mesh.corners.size());
      mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
      for (const int v : part.corners) mesh.corners.push_back(v + offset);
      for (int f = 0; f < part.face_count(); ++f) {
        mesh.first_corner.push_back(part.first_corner[static_cast<std::size_t>(f) + 1] + corners);
        place_.emplace_back(i, f);
      }
    }
  }

  /// A finding with the faces' numbers in the whole, and the parts that they are in.
  MeshDefect in_the_whole(MeshDefect finding) const {
    std::set<std::string> named;
    const auto face = [&](int f) {
      named.insert(part_of(f).name);
      return std::to_string(of_whole(f) + 1) + " of \"" + part_of(f).name + "\"";
    };
    const auto vertex = [](int) { return std::string(); };  // none is in these messages
    const std::string message = renumbered(finding.message, face, vertex);
    const bool nested = finding.kind == MeshDefectKind::nested_wrong;
    finding.message = (nested || named.size() > 1 ? "parts overlap: " : "all parts together: ") +
                      message + (nested ? ", or cut its place out of the part around it" : "");
    finding.face = of_whole(finding.face);
    return finding;
  }

  PolygonMesh mesh;

 private:
  const std::pair<std::size_t, int>& place(int f) const {
    return place_[static_cast<std::size_t>(f)];
  }
  const parts::Part& part_of(int f) const { return parts_[place(f).first]; }
  int of_whole(int f) const { return number_at(part_of(f).faces, place(f).second); }

  std::span<const parts::Part> parts_;
  std::vector<std::pair<std::size_t, int>> place_;  ///< of a face: its part, and which face of it
};

/// By how much a share of the mass may be larger than the same share of the volume, if it counts
/// for the densest of the parts: 1 if all densities are equal.
double densest_to_mean(std::span<const parts::Part> parts);

/// A crossing of parts is judged by the mass that counts wrongly.
/// @param factor as densest_to_mean() gives it
void weigh_share(MeshDefect& crossing, double factor);

/// Where parts pass through each other, or one lies in the inside of another.
std::vector<MeshDefect> find_overlaps(std::span<const parts::Part> parts,
                                      const simd::LoopOptions& options, crossings::Search search,
                                      std::optional<double> rounding);

}  // namespace tumble::detail

namespace tumble::parts {

/// @addtogroup mass
/// @{

/// Everything that is wrong with the parts: each has to be a closed surface by itself, and none may
/// lie where another one is. Parts may touch, and share vertices. Findings have the numbers of the
/// whole mesh, and the names of the parts. Whether parts overlap is only asked if each one is
/// closed, and as closely as whether one mesh crosses itself; the share of such a finding is the
/// largest share of the mass that may count wrongly.
/// @param rounding of the coordinates, as tumble::diagnose() takes it
std::vector<MeshDefect> diagnose(std::span<const Part> parts, const simd::LoopOptions& options = {},
                                 crossings::Search search = crossings::Search::usual,
                                 std::optional<double> rounding = {});

/// @}

}  // namespace tumble::parts

#ifndef TUMBLE_COMPILED
#include "tumble/mass/parts/diagnose.inl"
#endif
