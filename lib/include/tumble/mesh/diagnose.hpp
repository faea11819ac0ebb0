#pragma once
/// @file
/// Everything that is wrong with a mesh, in words; and the door at which such a mesh is refused.
///
/// The questions go from cheap to expensive, and later ones are only asked when the earlier ones
/// have good answers: do the vertices exist, is the surface closed (one pass, edge_balance.hpp),
/// and only if not, where; what do its parts enclose (components.hpp); do they bound a body
/// (check_parts.hpp). No threshold has a unit: a body of a micrometre, or 10⁸ m away, is judged
/// like any other.

#include <optional>
#include <string>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/mesh/components.hpp"
#include "tumble/mesh/crossing_pairs.hpp"
#include "tumble/mesh/crossing_search.hpp"
#include "tumble/mesh/line_bundle.hpp"
#include "tumble/mesh/mesh_defect.hpp"
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
TriangleMeetings meetings_for(const PolygonMesh& mesh, const Components& surface,
                              std::vector<char> hidden, crossings::Search search);

/// Finds surfaces that are there twice, also where they touch a body and share its vertices.
std::vector<MeshDefect> find_doubled_pieces(const PolygonMesh& mesh, const Components& surface,
                                            const Eigen::AlignedBox3d& box,
                                            std::optional<double> rounding);

/// Everything that is wrong with the parts of a closed surface.
/// @param all      what a pass over the mesh told
/// @param lattices the lines that it looked at
std::vector<MeshDefect> find_wrong_bodies(const PolygonMesh& mesh, const Survey& all,
                                          const Eigen::AlignedBox3d& box,
                                          const LineLattices& lattices, crossings::Search search,
                                          std::optional<double> rounding);

}  // namespace detail

/// Everything that is wrong with the mesh; empty when it bounds a body. A crossing comes with the
/// share of the volume that counts wrongly: spoils_integrals() says whether it is too much. At most
/// a few findings of each kind are listed, and the last one says how many more there are.
/// @param rounding how far a coordinate may be from what it was before it was written [m]. Without
///                 it we count the coordinates' digits; those of a file in inches are only known
///                 to those who have read it
std::vector<MeshDefect> diagnose(const PolygonMesh& mesh, const simd::LoopOptions& options = {},
                                 crossings::Search search = crossings::Search::usual,
                                 std::optional<double> rounding = {});

namespace detail {

/// All findings, one a line: what a refusal says.
std::string findings_text(const std::vector<MeshDefect>& findings);

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
void require_body(const std::vector<MeshDefect>& findings, Policy policy = Policy::refuse,
                  double tolerance = detail::crossing_tolerance);

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

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/diagnose.inl"
#endif
