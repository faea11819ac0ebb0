#pragma once

#include "tumble/mass/shell.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"
#include "tumble/mass/require_volume.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/reference_point.hpp"

namespace tumble::shells {

TUMBLE_BODY double area(const PolygonMesh& mesh) {
  simd::DoubleDouble sum;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3& a = mesh.vertex(t[0]);
    sum += (mesh.vertex(t[1]) - a).cross(mesh.vertex(t[2]) - a).norm() / 2;
  });
  return double(sum);
}

TUMBLE_BODY MassProperties mass_properties(const PolygonMesh& mesh, double surface_density) {
  require(surface_density > 0 && std::isfinite(surface_density), "the surface density ",
          surface_density, " kg/m² is not positive and finite");
  for (const auto& find : {detail::find_bad_indices, detail::find_not_finite})
    for (const MeshDefect& finding : find(mesh)) require(false, finding.message);
  const Vec3 p = detail::reference_point(mesh);
  detail::BlockedMoments sum;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3 a = mesh.vertex(t[0]) - p, b = mesh.vertex(t[1]) - p, c = mesh.vertex(t[2]) - p;
    const double A = (mesh.vertex(t[1]) - mesh.vertex(t[0]))
                         .cross(mesh.vertex(t[2]) - mesh.vertex(t[0]))
                         .norm() /
                     2;
    const Vec3 s = a + b + c, first = A / 3 * s;
    const Mat3 second =
        A / 12 * (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    sum.add({A, first.x(), first.y(), first.z(), second(0, 0), second(1, 1), second(2, 2),
             second(0, 1), second(1, 2), second(2, 0)});
  });
  const Moments<simd::DoubleDouble> total = sum.total();
  require(double(total.one) > 0 && std::isfinite(double(total.one)),
          "the surface has no area: there is no shell");
  // Digits that the integrals don't have come with no density.
  detail::require_normal(tumble::mass_properties(total, p, 1), "shell");
  MassProperties shell = tumble::mass_properties(total, p, surface_density);
  detail::require_normal(shell, "shell");
  return shell;
}

}  // namespace tumble::shells
