#pragma once
/// @file
/// What is wrong with the parts of a mesh, each by itself and all together, in words that name
/// them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/parts/renumbered.hpp"
#include "tumble/mass/parts/split.hpp"
#include "tumble/mesh/diagnose.hpp"

namespace tumble::detail {

inline int number_at(const std::vector<int>& numbers, int i) {
  return i < 0 ? i : numbers[static_cast<std::size_t>(i)];
}

/// A finding of a part's own mesh as one of the whole mesh.
inline MeshDefect in_the_whole(MeshDefect finding, const parts::Part& part) {
  const auto number = [](const std::vector<int>& of_whole) {
    return [&of_whole](int i) { return std::to_string(number_at(of_whole, i) + 1); };
  };
  finding.message = "\"" + part.name +
                    "\": " + renumbered(finding.message, number(part.faces), number(part.vertices));
  finding.face = number_at(part.faces, finding.face);
  for (int& v : finding.edge) v = number_at(part.vertices, v);
  return finding;
}

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
inline double densest_to_mean(std::span<const parts::Part> parts) {
  double volume = 0, mass = 0, densest = 0;
  for (const parts::Part& part : parts) {
    const double v = unchecked_mass_properties(part.mesh, 1, Accuracy::fast).mass;
    volume += v;
    mass += v * part.density;
    densest = std::max(densest, part.density);
  }
  return densest * volume / mass;
}

/// A crossing of parts is judged by the mass that counts wrongly.
/// @param factor as densest_to_mean() gives it
inline void weigh_share(MeshDefect& crossing, double factor) {
  if (std::isnan(crossing.share)) return;
  crossing.share *= factor;
  crossing.share_uncertainty *= factor;
  std::array<char, 40> share{};
  std::snprintf(share.data(), share.size(), "%.2g", crossing.share);
  crossing.message += ", up to " + std::string(share.data()) + " of the mass";
}

/// Where parts pass through each other, or one lies in the inside of another.
inline std::vector<MeshDefect> find_overlaps(std::span<const parts::Part> parts,
                                             const simd::LoopOptions& options,
                                             crossings::Search search,
                                             std::optional<double> rounding) {
  const SideBySide all(parts);
  std::vector<MeshDefect> findings;
  for (const MeshDefect& finding : tumble::diagnose(all.mesh, options, search, rounding))
    if (finding.kind == MeshDefectKind::self_crossing ||
        finding.kind == MeshDefectKind::nested_wrong)
      findings.push_back(all.in_the_whole(finding));
  for (MeshDefect& finding : findings)
    if (finding.kind == MeshDefectKind::self_crossing) weigh_share(finding, densest_to_mean(parts));
  return findings;
}

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
inline std::vector<MeshDefect> diagnose(std::span<const Part> parts,
                                        const simd::LoopOptions& options = {},
                                        crossings::Search search = crossings::Search::usual,
                                        std::optional<double> rounding = {}) {
  std::vector<MeshDefect> findings;
  for (const Part& part : parts)
    for (const MeshDefect& finding : tumble::diagnose(part.mesh, options, search, rounding))
      findings.push_back(detail::in_the_whole(finding, part));
  const bool all_closed =
      std::none_of(findings.begin(), findings.end(), [](const MeshDefect& finding) {
        return spoils_integrals(finding) && finding.kind != MeshDefectKind::self_crossing;
      });
  if (parts.size() < 2 || !all_closed) return findings;
  for (const MeshDefect& overlap : detail::find_overlaps(parts, options, search, rounding))
    findings.push_back(overlap);
  return findings;
}

/// @}

}  // namespace tumble::parts
