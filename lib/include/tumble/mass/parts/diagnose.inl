#pragma once

#include "tumble/mass/parts/diagnose.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"

namespace tumble::detail {

TUMBLE_BODY MeshDefect in_the_whole(MeshDefect finding, const parts::Part& part) {
  const auto number = [](const std::vector<int>& of_whole) {
    return [&of_whole](int i) { return std::to_string(number_at(of_whole, i) + 1); };
  };
  finding.message = "\"" + part.name +
                    "\": " + renumbered(finding.message, number(part.faces), number(part.vertices));
  finding.face = number_at(part.faces, finding.face);
  for (int& v : finding.edge) v = number_at(part.vertices, v);
  return finding;
}

TUMBLE_BODY double densest_to_mean(std::span<const parts::Part> parts) {
  double volume = 0, mass = 0, densest = 0;
  for (const parts::Part& part : parts) {
    const double v = unchecked_mass_properties(part.mesh, 1, Accuracy::fast).mass;
    volume += v;
    mass += v * part.density;
    densest = std::max(densest, part.density);
  }
  return densest * volume / mass;
}

TUMBLE_BODY void weigh_share(MeshDefect& crossing, double factor) {
  if (std::isnan(crossing.share)) return;
  crossing.share *= factor;
  crossing.share_uncertainty *= factor;
  std::array<char, 40> share{};
  std::snprintf(share.data(), share.size(), "%.2g", crossing.share);
  crossing.message += ", up to " + std::string(share.data()) + " of the mass";
}

TUMBLE_BODY std::vector<MeshDefect> find_overlaps(std::span<const parts::Part> parts,
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

TUMBLE_BODY std::vector<MeshDefect> diagnose(std::span<const Part> parts,
                                             const simd::LoopOptions& options,
                                             crossings::Search search,
                                             std::optional<double> rounding) {
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

}  // namespace tumble::parts
