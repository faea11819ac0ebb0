#pragma once
/// @file
/// A box that is cut into cells, each cell a point.

#include "common.hpp"

namespace point_sampling_chapter {

/// A box that its cells fill exactly: what is missing is the cells' own inertia.
inline Table cells_table() {
  Table table({"cells", "mass", "I_zz", "missing", "1/n²"});
  const Box plank{Vec3(1, 0.2, 0.05)};
  const MassProperties truth = mass_properties(plank, 500);
  for (const int n : {1, 2, 4, 8, 16}) {
    const auto body = sample_mass_properties(plank, 500, GridPoints(n));
    table.add(
        {number(n) + "³", number(body.mass, 6) + " kg", number(body.inertia(2, 2), 6) + " kg m²",
         percent(1 - body.inertia(2, 2) / truth.inertia(2, 2), 5), percent(1.0 / (n * n), 5)});
  }
  return table;
}

}  // namespace point_sampling_chapter
