#pragma once
/// @file
/// Everything that is wrong with a mesh, in words; and the door at which such a mesh is refused.
///
/// The questions go from cheap to dear, and later ones are only asked when the earlier ones have
/// good answers: do the vertices exist, is the surface closed (one pass, edge_balance.hpp), and
/// only if not, where; what do its parts enclose (components.hpp); do they bound a body
/// (check_parts.hpp). No threshold has a unit: a body of a micrometre, or 10⁸ m away, is judged
/// like any other.

#include <algorithm>
#include <string>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/mesh/check_edges.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/check_parts.hpp"
#include "tumble/mesh/components.hpp"
#include "tumble/mesh/finding.hpp"

namespace tumble {

/// How many vertical lines are spread over a mesh: they miss a crossing that covers less than about
/// a thousandth of what is seen from above.
inline constexpr int diagnosis_lines = 1024;

/// Everything that is wrong with the mesh; empty when it bounds a body. At most a few findings of
/// each kind are listed, and the last one says how many more there are.
inline std::vector<Finding> diagnose(const PolygonMesh& mesh) {
  std::vector<Finding> findings = find_bad_indices(mesh);
  if (!findings.empty()) return findings;
  if (mesh.face_count() == 0)
    return {Finding{FindingKind::no_faces, -1, {-1, -1}, "the mesh has no faces"}};
  const auto add = [&findings](const std::vector<Finding>& more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  const bool closed = is_closed(mesh);
  findings = find_not_finite(mesh);
  const bool finite = findings.empty();
  if (!closed) {
    add(find_duplicate_faces(mesh));
    add(find_uneven_edges(mesh));
  }
  if (!finite) return findings;
  const Components surface = components(mesh);
  if (surface.doubtful_faces > 0) add(find_degenerate_faces(mesh));
  if (!closed) return findings;
  add(find_flat_parts(mesh, surface));
  add(find_wrong_depth(mesh, surface, hits_of_bundle(mesh, surface, diagnosis_lines)));
  return findings;
}

/// All findings, one a line: what a refusal says.
inline std::string findings_text(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings)
    text += std::string("\n  ") + name(finding.kind) + ": " + finding.message;
  return text;
}

/// Lets a mesh pass that bounds a body, and refuses any other: what a computation of mass asks
/// first. Real meshes have faces without area; they add nothing to an integral and alone are no
/// reason to refuse here: require_faultless() does.
/// @throws std::invalid_argument with all findings, one a line
inline void require_body(const PolygonMesh& mesh) {
  const std::vector<Finding> findings = diagnose(mesh);
  const bool good = std::none_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return spoils_integrals(finding.kind);
  });
  require(good, "the mesh does not bound a body:", findings_text(findings));
}

/// Lets a mesh pass in which nothing at all was found, degenerate faces included: what a program
/// asks that divides by a face's area or needs its normal.
/// @throws std::invalid_argument with all findings, one a line
inline void require_faultless(const PolygonMesh& mesh) {
  const std::vector<Finding> findings = diagnose(mesh);
  require(findings.empty(), "the mesh has faults:", findings_text(findings));
}

}  // namespace tumble
