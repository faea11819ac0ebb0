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
#include "tumble/mesh/edge_balance.hpp"
#include "tumble/mesh/finite_bounds.hpp"
#include "tumble/mesh/mesh_defect.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

namespace detail {

/// How many vertical lines are spread over a mesh: they miss a crossing that covers less than about
/// a thousandth of what is seen from above.
inline constexpr int diagnosis_lines = 1024;

/// What one pass over the triangles tells.
struct Survey {
  std::uint64_t balance = 0;  ///< 0: closed, and the faces agree on what is outside
  EnclosedVolume enclosed;
  TrianglesNearLines near_lines;

  Survey& operator+=(const Survey& other) {
    balance += other.balance;
    enclosed += other.enclosed;
    near_lines += other.near_lines;
    return *this;
  }
};

/// Goes over all triangles once.
/// @param mesh indices in range, positions finite
inline Survey survey(const PolygonMesh& mesh, const LatticeFilter& filter,
                     const simd::LoopOptions& options) {
  const Vec3 origin = mesh.corners.empty() ? Vec3(0, 0, 0) : mesh.vertex(mesh.corners[0]);
  const auto add = [&](const TriangleBlock& block, Survey& sum) {
    dispatch(options.instructions, BlockBalance{block, sum.balance});
    dispatch(options.instructions, BlockVolume{block, origin, sum.enclosed});
    dispatch(options.instructions, BlockNearLines{block, filter, sum.near_lines});
  };
  return sum_over_blocks<Survey>(mesh, options, add);
}

}  // namespace detail

/// Everything that is wrong with the mesh; empty when it bounds a body. At most a few findings of
/// each kind are listed, and the last one says how many more there are.
inline std::vector<MeshDefect> diagnose(const PolygonMesh& mesh,
                                        const simd::LoopOptions& options = {}) {
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
  const detail::LineLattice lattice(bounds.box, detail::diagnosis_lines);
  const detail::Survey all = detail::survey(mesh, lattice.filter(), options);
  if (all.balance != 0) add_edge_defects();
  if (all.enclosed.doubtful > 0 || detail::has_short_faces(mesh))
    add(detail::find_degenerate_faces(mesh));
  add(detail::find_nonplanar_faces(mesh));
  if (all.balance != 0) return findings;
  const detail::Components surface = detail::components(mesh, all.enclosed);
  add(detail::find_flat_parts(mesh, surface));
  add(detail::find_wrong_depth(
      mesh, surface, detail::hits_of_bundle(mesh, surface, bounds.box, lattice, all.near_lines)));
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

/// Lets findings pass with which the integrals over a mesh are right, or with Policy::accept at
/// least possible. Real meshes have faces without area; they add nothing to an integral and alone
/// are no reason to refuse here: require_faultless() does.
/// @throws std::invalid_argument with all findings, one a line
inline void require_body(const std::vector<MeshDefect>& findings, Policy policy = Policy::refuse) {
  const auto refused = policy == Policy::refuse ? spoils_integrals : prevents_integrals;
  const bool good = std::none_of(findings.begin(), findings.end(),
                                 [&](const MeshDefect& finding) { return refused(finding.kind); });
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
