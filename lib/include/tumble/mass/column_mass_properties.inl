#pragma once

#include "tumble/mass/column_mass_properties.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"
#include "tumble/mass/require_density.hpp"
#include "tumble/mesh/closed_surface.hpp"
#include "tumble/mesh/enclosed_volume.hpp"
#include "tumble/mesh/jittered_lines.hpp"
#include "tumble/mesh/line_lattice.hpp"

namespace tumble::detail {

TUMBLE_BODY void require_columns(const PolygonMesh& mesh, double density, int columns) {
  require_density(density);
  constexpr int max_columns = 100'000'000;
  require(columns > 0 && columns <= max_columns, "the number of columns is ", columns,
          ", not in 1 … ", max_columns);
  require_closed(mesh);
}

TUMBLE_BODY sampling::ColumnMassProperties require_resolved(
    const PolygonMesh& mesh, double density, const sampling::ColumnMassProperties& body) {
  require(body.crossings > 0, "none of ", body.columns, " columns met the mesh: take more");
  const double mass = density * enclosed_volume(mesh);
  require(mass > 0, "the mesh is inside out, or encloses no volume: mass ", mass, " kg");
  require(std::abs(body.mass - mass) <= mass / 2, body.columns,
          " columns are too few for so thin a body: they make ", body.mass,
          " kg of it, its surface encloses ", mass, " kg");
  return body;
}

}  // namespace tumble::detail

namespace tumble::sampling {

TUMBLE_BODY ColumnMassProperties column_mass_properties(const PolygonMesh& mesh, double density,
                                                        int columns) {
  detail::require_columns(mesh, density, columns);
  const detail::LineLattice lines =
      detail::LineLattice::regular(detail::centred(bounds(mesh)), columns);
  return detail::require_resolved(mesh, density, detail::sum_of_columns(mesh, density, lines));
}

TUMBLE_BODY ColumnMassProperties jittered_column_mass_properties(const PolygonMesh& mesh,
                                                                 double density, int columns,
                                                                 std::uint64_t seed) {
  detail::require_columns(mesh, density, columns);
  const detail::JitteredLines lines(detail::centred(bounds(mesh)), columns, seed);
  return detail::require_resolved(mesh, density, detail::sum_of_columns(mesh, density, lines));
}

}  // namespace tumble::sampling
