#pragma once
/// @file
/// The parts of a mesh, as diagnose() asks for them.

#include "tumble/mesh/diagnose.hpp"

namespace tumble::test {

inline detail::Components parts_of(const PolygonMesh& mesh) {
  const detail::LineLattices lattices(bounds(mesh), 16);
  return components(mesh, survey(mesh, filters_of(lattices), {}).enclosed);
}

}  // namespace tumble::test
