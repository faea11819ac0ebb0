#pragma once

#include "tumble/mesh/diagnose.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/check_crossing.hpp"
#include "tumble/mesh/check_edges.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/check_parts.hpp"
#include "tumble/mesh/closed_pieces.hpp"
#include "tumble/mesh/doubled_surface.hpp"
#include "tumble/mesh/finite_bounds.hpp"
#include "tumble/mesh/part_overlaps.hpp"
#include "tumble/mesh/stray_faces.hpp"

namespace tumble::detail {

TUMBLE_BODY TriangleMeetings meetings_for(const PolygonMesh& mesh, const Components& surface,
                                          std::vector<char> hidden, crossings::Search search) {
  constexpr int few = 100;            // a face, or a part
  constexpr double affordable = 2e7;  // pairs of a mesh: half a second
  if (search == crossings::Search::thorough || mesh.face_count() <= always_pairs)
    return find_meetings(mesh, boxed_triangles(mesh));
  const bool any_hidden = std::find(hidden.begin(), hidden.end(), 1) != hidden.end();
  if (mesh.face_count() <= few_pairs) {
    if (!any_hidden)
      return find_meetings(mesh, boxed_triangles(mesh),
                           std::max<double>(few, affordable / mesh.face_count()));
    // A grid around parts that are far from each other has no use: each part has its own.
    hidden.assign(hidden.size(), 1);
  }
  if (!any_hidden && hidden.size() == 1) return {};
  return meetings_of_parts(mesh, surface, hidden, few_pairs, few);
}

TUMBLE_BODY std::vector<MeshDefect> find_doubled_pieces(const PolygonMesh& mesh,
                                                        const Components& surface,
                                                        const Eigen::AlignedBox3d& box,
                                                        std::optional<double> rounding) {
  if (!is_pinched(mesh)) return find_doubled_surfaces(mesh, surface, box, rounding);
  const PolygonMesh apart = apart_at_pinches(mesh);
  return find_doubled_surfaces(apart, components(apart, enclosed_by(apart)), box, rounding);
}

TUMBLE_BODY std::vector<MeshDefect> find_wrong_bodies(const PolygonMesh& mesh, const Survey& all,
                                                      const Eigen::AlignedBox3d& box,
                                                      const LineLattices& lattices,
                                                      crossings::Search search,
                                                      std::optional<double> rounding) {
  const Components surface = components(mesh, all.enclosed);
  constexpr double enough = 0.25;  // of the lines
  const std::vector<char> hidden = hardly_seen_parts(mesh, surface, box, enough);
  const bool also_touching = search == crossings::Search::thorough ||
                             mesh.face_count() <= always_pairs ||
                             std::find(hidden.begin(), hidden.end(), 1) != hidden.end();
  const CrossingQuestion question{mesh,           surface,       box,     lattices,
                                  all.near_lines, also_touching, rounding};
  const LineBundle lines = question.hits(double_blur(box));
  std::vector<MeshDefect> findings = find_flat_parts(mesh, surface);
  const auto spoils = [](const MeshDefect& finding) { return spoils_integrals(finding); };
  if (std::none_of(findings.begin(), findings.end(), spoils)) {
    auto doubled = find_doubled_pieces(mesh, surface, box, rounding);
    if (!doubled.empty()) return doubled;
  }
  const std::vector<MeshDefect> depth =
      find_wrong_depth(question, meetings_for(mesh, surface, hidden, search), lines);
  findings.insert(findings.end(), depth.begin(), depth.end());
  return findings;
}

}  // namespace tumble::detail

namespace tumble {

TUMBLE_BODY std::vector<MeshDefect> diagnose(const PolygonMesh& mesh,
                                             const simd::LoopOptions& options,
                                             crossings::Search search,
                                             std::optional<double> rounding) {
  std::vector<MeshDefect> findings = detail::find_bad_indices(mesh);
  if (!findings.empty()) return findings;
  if (mesh.face_count() == 0)
    return {MeshDefect{.kind = MeshDefectKind::no_faces, .message = "the mesh has no faces"}};
  const auto add = [&findings](const std::vector<MeshDefect>& more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  const auto add_edge_defects = [&] {
    add(detail::find_duplicate_faces(mesh));
    add(detail::find_uneven_edges(mesh));
  };
  const detail::FiniteBounds bounds = detail::finite_bounds(mesh, options.instructions);
  if (!bounds.finite) {
    add(detail::find_not_finite(mesh));
    if (!detail::is_closed(mesh, options)) add_edge_defects();
    return findings;
  }
  const detail::LineLattices lattices(bounds.box, detail::diagnosis_lines);
  detail::Survey all = detail::survey(mesh, detail::filters_of(lattices), options);
  std::optional<PolygonMesh> closed;
  if (all.balance != 0 && all.enclosed.doubtful > 0) closed = detail::without_stray_faces(mesh);
  if (all.balance != 0 && !closed) add_edge_defects();
  if (all.enclosed.doubtful > 0 || detail::has_short_faces(mesh))
    add(detail::find_degenerate_faces(mesh));
  add(detail::find_nonplanar_faces(mesh));
  if (all.balance != 0 && !closed) return findings;
  if (closed) all = detail::survey(*closed, detail::filters_of(lattices), options);
  add(detail::find_wrong_bodies(closed ? *closed : mesh, all, bounds.box, lattices, search,
                                rounding));
  return findings;
}

}  // namespace tumble

namespace tumble::detail {

TUMBLE_BODY std::string findings_text(const std::vector<MeshDefect>& findings) {
  std::string text;
  for (const MeshDefect& finding : findings)
    text += std::string("\n  ") + name_of(finding.kind) + ": " + finding.message;
  return text;
}

}  // namespace tumble::detail

namespace tumble {

TUMBLE_BODY void require_body(const std::vector<MeshDefect>& findings, Policy policy,
                              double tolerance) {
  const auto refused = [=](const MeshDefect& finding) {
    return policy == Policy::refuse ? spoils_integrals(finding, tolerance)
                                    : prevents_integrals(finding.kind);
  };
  const bool good = std::none_of(findings.begin(), findings.end(), refused);
  require(good, "the mesh does not bound a body:", detail::findings_text(findings));
}

}  // namespace tumble
