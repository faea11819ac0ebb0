#pragma once
/// @file
/// What must hold for any mesh whatever: the diagnosis ends, a mesh that it passes has mass
/// properties that are right within their bounds, and any other is refused with words.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mesh/check_edges.hpp"
#include "tumble/mesh/mesh_solid.hpp"

namespace tumble::fuzz {

/// Stops the program, which is what a fuzzer looks for.
inline void demand(bool condition, const char* law) {
  if (condition) return;
  std::fprintf(stderr, "broken law: %s\n", law);
  std::abort();
}

/// Whether two numbers that should be equal are, up to relative errors.
inline bool agree(double a, double b, double error) {
  return std::abs(a - b) <= error * std::max(std::abs(a), std::abs(b));
}

/// Calls `use`, which may refuse but not fail.
/// @return whether it refused
template <class Use>
bool refuses(const Use& use) {
  try {
    use();
  } catch (const std::invalid_argument& refusal) {
    demand(refusal.what()[0] != 0, "a refusal has words");
    return true;
  }
  return false;
}

/// The three ways to integrate agree within the sum of their bounds.
inline void check_integrals(const PolygonMesh& mesh, const BoundedMassProperties& tight) {
  demand(tight.mass > 0 && std::isfinite(tight.mass), "the mass is a positive number");
  demand(tight.inertia.allFinite() && tight.centre.allFinite(), "all numbers are finite");
  for (const Accuracy accuracy : {Accuracy::fast, Accuracy::textbook}) {
    const BoundedMassProperties other = unchecked_mass_properties(mesh, 1, accuracy);
    const double mass_error = tight.mass_error_bound + other.mass_error_bound;
    if (mass_error < 0.1)
      demand(agree(tight.mass, other.mass, 1.2 * mass_error), "masses agree within their bounds");
    const double inertia_error = tight.inertia_error_bound + other.inertia_error_bound;
    if (inertia_error < 0.1)
      demand((tight.inertia - other.inertia).norm() <= 1.2 * inertia_error * tight.inertia.norm(),
             "tensors agree within their bounds");
  }
}

/// Whether each edge is used equally often both ways, edge by edge.
inline bool closed_by_counting(const PolygonMesh& mesh) {
  bool closed = true;
  detail::for_each_uneven_edge(detail::edge_uses(mesh),
                               [&](std::span<const detail::EdgeUse>) { closed = false; });
  return closed;
}

inline void check_mesh(const PolygonMesh& mesh) {
  const std::vector<MeshDefect> findings = diagnose(mesh);
  for (const MeshDefect& finding : findings)
    demand(!finding.message.empty(), "a finding has words");
  if (detail::find_bad_indices(mesh).empty())
    demand(detail::is_closed(mesh) == closed_by_counting(mesh),
           "the fingerprint knows what is closed");
  const bool spoilt = refuses([&] { require_body(findings); });
  BoundedMassProperties tight;
  const bool refused = refuses([&] { tight = mesh_mass_properties(mesh, 1); });
  demand(refused || !spoilt, "what the diagnosis refuses has no mass properties");
  if (!refused) check_integrals(mesh, tight);
  refuses([&] { mesh_mass_properties(mesh, 1, {.policy = Policy::accept}); });
  refuses([&] {
    const MeshSolid solid(mesh);
    solid.contains(solid.bounds().center());
  });
}

}  // namespace tumble::fuzz
