/// @file
/// A body far from the origin: what is left of its digits.

#include <limits>

#include "common.hpp"
#include "far_mug.hpp"
#include "objects/mug.hpp"
#include "parts.hpp"
#include "support/plot.hpp"
#include "tumble/mesh/reference_point.hpp"

namespace mirtich_chapter {

namespace {

double diameter(const PolygonMesh& mesh) { return bounds(mesh).diagonal().norm(); }

/// Errors of the ways to sum, the worst in all directions.
struct FarErrors {
  double mass_corners = 0, mass_edges = 0, corners = 0, edges = 0, near = 0;
};

FarErrors far_errors(double distance) {
  FarErrors worst;
  const auto note = [](double& error, double another) { error = std::max(error, another); };
  for (const Vec3& way : ways_off) {
    const PolygonMesh mesh = mug_at(distance, way);
    const MassProperties truth = exact(mesh), near = plain_loop(mesh);
    const auto corners = one_by_one<double>(mesh, Vec3::Zero(), six_volume_of_corners);
    const auto edges = one_by_one<double>(mesh, Vec3::Zero(), six_volume_of_edges);
    note(worst.mass_corners, mass_error(corners, truth));
    note(worst.mass_edges, mass_error(edges, truth));
    note(worst.corners, inertia_error(corners, truth));
    note(worst.edges, inertia_error(edges, truth));
    note(worst.near, std::max(mass_error(near, truth), inertia_error(near, truth)));
  }
  return worst;
}

/// What Mirtich's three steps find about a point.
MassProperties by_shadows(const PolygonMesh& mesh, const Vec3& p) {
  return mass_properties(mirtich::volume_integrals(mesh, p), p, 1);
}

using Long = Vector3<simd::DoubleDouble>;

/// The centre of mass in 32 digits.
Long exact_centre(const PolygonMesh& mesh) {
  const Vec3 p = detail::reference_point(mesh);
  const MassProperties near = exact(moved(mesh, -p));  // p is near: the vertices move exactly
  return near.centre.cast<simd::DoubleDouble>() + p.cast<simd::DoubleDouble>();
}

/// How far the centre is off, without and with what rounding took from it [m].
struct CentreErrors {
  double alone, with_rest;
};

CentreErrors centre_errors(double distance) {
  CentreErrors worst{0, 0};
  for (const Vec3& way : ways_off) {
    const PolygonMesh mesh = mug_at(distance, way);
    const BoundedMassProperties found = computed(mesh, Accuracy::tight);
    const Long truth = exact_centre(mesh), alone = found.centre.cast<simd::DoubleDouble>();
    const Long both = alone + found.centre_rest.cast<simd::DoubleDouble>();
    worst.alone = std::max(worst.alone, detail::to_double(alone - truth).norm());
    worst.with_rest = std::max(worst.with_rest, detail::to_double(both - truth).norm());
  }
  return worst;
}

}  // namespace

Table far_by_shadows_table() {
  Table table({"distance", "mass", "inertia", "about the body: mass", "inertia"});
  for (const double distance : {1., 10., 100., 1e3, 1e4, 1e6, 1e8}) {
    std::array<double, 4> worst{};
    for (const Vec3& way : ways_off) {
      const PolygonMesh mesh = mug_at(distance, way);
      const MassProperties truth = exact(mesh), far = by_shadows(mesh, Vec3::Zero()),
                           near = by_shadows(mesh, detail::reference_point(mesh));
      const std::array errors{mass_error(far, truth), inertia_error(far, truth),
                              mass_error(near, truth), inertia_error(near, truth)};
      for (std::size_t i = 0; i < 4; ++i) worst[i] = std::max(worst[i], errors[i]);
    }
    table.add({number(distance) + " m", while_any(worst[0]), while_any(worst[1]),
               while_any(worst[2]), while_any(worst[3])});
  }
  return table;
}

Table far_table() {
  Table table(
      {"distance", "mass: corners", "edges", "inertia: corners", "edges", "about the body"});
  for (const double distance : {0.1, 1., 1e1, 1e2, 1e3, 1e4, 1e6, 1e8}) {
    const FarErrors e = far_errors(distance);
    table.add({number(distance) + " m", while_any(e.mass_corners), while_any(e.mass_edges),
               while_any(e.corners), while_any(e.edges), while_any(e.near)});
  }
  return table;
}

Table rest_table() {
  Table table({"distance", "next double [m]", "centre off by", "centre + centre_rest off by"});
  for (const double distance : {1., 1e3, 1e6, 1e8}) {
    const CentreErrors e = centre_errors(distance);
    const double gap = std::nextafter(distance, std::numeric_limits<double>::infinity()) - distance;
    const auto metres = [](double error) {
      return error < 1e-15 ? std::string("< 1e-15 m") : error_number(error) + " m";
    };
    table.add({number(distance) + " m", number(gap, 2), metres(e.alone), metres(e.with_rest)});
  }
  return table;
}

std::string far_figure() {
  support::Plot plot{"a mug of 1388 triangles",
                     {"distance from the origin, in diameters of the mug", support::Scale::log},
                     {"error: inertia relative, centre in diameters", support::Scale::log},
                     {}};
  const std::array<std::string, 5> names{"inertia, corners", "inertia, edges", "centre, rounded",
                                         "inertia, about the body", "centre + centre_rest"};
  for (const std::string& name : names) plot.series.push_back({name, {}, {}});
  for (int i = 0; i <= 18; ++i) {
    const double distance = 0.1 * std::pow(10, 0.5 * i), size = diameter(objects::mug(1));
    const FarErrors e = far_errors(distance);
    const CentreErrors centre = centre_errors(distance);
    const std::array<double, 5> errors{e.corners, e.edges, centre.alone / size, e.near,
                                       centre.with_rest / size};
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (errors[k] > 3) continue;
      plot.series[k].x.push_back(distance / size);
      plot.series[k].y.push_back(std::max(errors[k], 0x1p-53));
    }
  }
  return support::to_svg(plot);
}

}  // namespace mirtich_chapter
