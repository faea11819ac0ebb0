#pragma once
/// @file
/// Everything that is wrong with a mesh, in words; and the door at which such a mesh is refused.
///
/// The questions go from cheap to expensive, and later ones are only asked when the earlier ones
/// have good answers: do the vertices exist, is the surface closed (one pass, edge_balance.hpp),
/// and only if not, where; what do its parts enclose (components.hpp); do they bound a body
/// (check_parts.hpp). No threshold has a unit: a body of a micrometre, or 10⁸ m away, is judged
/// like any other.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/mesh/check_crossing.hpp"
#include "tumble/mesh/check_edges.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/check_parts.hpp"
#include "tumble/mesh/components.hpp"
#include "tumble/mesh/crossing_search.hpp"
#include "tumble/mesh/doubled_surface.hpp"
#include "tumble/mesh/finite_bounds.hpp"
#include "tumble/mesh/mesh_defect.hpp"
#include "tumble/mesh/part_overlaps.hpp"
#include "tumble/mesh/stray_faces.hpp"
#include "tumble/mesh/survey.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

namespace detail {

/// How many lines are spread over a mesh along each axis: they miss a crossing that covers less
/// than about a four-thousandth of what is seen from all three sides.
inline constexpr int diagnosis_lines = 4096;

/// Up to how many faces all pairs are looked at anyway, whatever it costs; and up to how many, if a
/// triangle has few others next to it. A pair costs some 25 ns. A sphere or a slim ellipsoid has 25
/// to 50 a face: 0.6 to 1.2 µs, so at most about 40 ms where the lines cost 4 ms. The fans of a
/// cone of 3000 faces have 5000 a face; they take 0.4 s, ten times as many faces would take 30 s.
inline constexpr int always_pairs = 3'000, few_pairs = 30'000;

/// The pairs that a search looks at: in a large mesh those of triangles that lie where another part
/// may be, or in a part that has few lines.
/// @param hidden the parts that have few lines
inline TriangleMeetings meetings_for(const PolygonMesh& mesh, const Components& surface,
                                     std::vector<char> hidden, crossings::Search search) {
  constexpr int few = 100;  // a face, or a part
  if (search == crossings::Search::thorough || mesh.face_count() <= always_pairs)
    return find_meetings(mesh, boxed_triangles(mesh));
  const bool any_hidden = std::find(hidden.begin(), hidden.end(), 1) != hidden.end();
  if (mesh.face_count() <= few_pairs) {
    if (!any_hidden) return find_meetings(mesh, boxed_triangles(mesh), few);
    // A grid around parts that are far from each other has no use: each part has its own.
    hidden.assign(hidden.size(), 1);
  }
  if (!any_hidden && hidden.size() == 1) return {};
  return meetings_of_parts(mesh, surface, hidden, few_pairs, few);
}

/// Everything that is wrong with the parts of a closed surface.
/// @param all      what a pass over the mesh told
/// @param lattices the lines that it looked at
inline std::vector<MeshDefect> find_wrong_bodies(const PolygonMesh& mesh, const Survey& all,
                                                 const Eigen::AlignedBox3d& box,
                                                 const LineLattices& lattices,
                                                 crossings::Search search,
                                                 std::optional<double> rounding) {
  const Components surface = components(mesh, all.enclosed);
  std::vector<MeshDefect> findings = find_flat_parts(mesh, surface);
  const auto spoils = [](const MeshDefect& finding) { return spoils_integrals(finding); };
  if (std::none_of(findings.begin(), findings.end(), spoils)) {
    auto doubled = find_doubled_surfaces(mesh, surface, box, rounding);
    if (!doubled.empty()) return doubled;
  }
  constexpr double enough = 0.25;  // of the lines
  const std::vector<char> hidden = hardly_seen_parts(mesh, surface, box, enough);
  const bool also_touching = search == crossings::Search::thorough ||
                             std::find(hidden.begin(), hidden.end(), 1) != hidden.end();
  const std::vector<MeshDefect> depth =
      find_wrong_depth({mesh, surface, box, lattices, all.near_lines, also_touching, rounding},
                       meetings_for(mesh, surface, hidden, search));
  findings.insert(findings.end(), depth.begin(), depth.end());
  return findings;
}

}  // namespace detail

/// Everything that is wrong with the mesh; empty when it bounds a body. A crossing comes with the
/// share of the volume that counts wrongly: spoils_integrals() says whether it is too much. At most
/// a few findings of each kind are listed, and the last one says how many more there are.
/// @param rounding how far a coordinate may be from what it was before it was written [m]. Without
///                 it we count the coordinates' digits; those of a file in inches are only known
///                 to those who have read it
inline std::vector<MeshDefect> diagnose(const PolygonMesh& mesh,
                                        const simd::LoopOptions& options = {},
                                        crossings::Search search = crossings::Search::usual,
                                        std::optional<double> rounding = {}) {
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

namespace detail {

/// All findings, one a line: what a refusal says.
inline std::string findings_text(const std::vector<MeshDefect>& findings) {
  std::string text;
  for (const MeshDefect& finding : findings)
    text += std::string("\n  ") + name_of(finding.kind) + ": " + finding.message;
  return text;
}

}  // namespace detail

/// What happens to a mesh that does not bound a body.
enum class Policy {
  refuse,  ///< an exception that says what is wrong and where
  accept,  ///< integrals as they come, and the findings beside them
};

/// Accepts findings that leave the integrals over a mesh right; with Policy::accept, also those
/// that leave them computable. Real meshes have faces without area; they add nothing to an integral
/// and alone are no reason to refuse here: require_faultless() does.
/// @param tolerance the share of the volume that may count wrongly because the surface crosses
///                  itself
/// @throws std::invalid_argument with all findings, one a line
inline void require_body(const std::vector<MeshDefect>& findings, Policy policy = Policy::refuse,
                         double tolerance = detail::crossing_tolerance) {
  const auto refused = [=](const MeshDefect& finding) {
    return policy == Policy::refuse ? spoils_integrals(finding, tolerance)
                                    : prevents_integrals(finding.kind);
  };
  const bool good = std::none_of(findings.begin(), findings.end(), refused);
  require(good, "the mesh does not bound a body:", detail::findings_text(findings));
}

/// Lets a mesh pass that bounds a body, and refuses any other.
/// @throws std::invalid_argument with all findings, one a line
inline void require_body(const PolygonMesh& mesh) { require_body(diagnose(mesh)); }

namespace detail {

/// Lets a mesh pass in which nothing at all was found, degenerate faces included: what a program
/// asks that divides by a face's area or needs its normal.
/// @throws std::invalid_argument with all findings, one a line
inline void require_faultless(const PolygonMesh& mesh) {
  const std::vector<MeshDefect> findings = diagnose(mesh);
  require(findings.empty(), "the mesh has faults:", findings_text(findings));
}

}  // namespace detail

/// @}

}  // namespace tumble
