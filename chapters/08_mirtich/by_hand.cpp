/// @file
/// What fits on paper: the corner of a cube, a gem with a face turned round, a square with a dent.

#include <cmath>

#include "common.hpp"
#include "corner_of_a_cube.hpp"
#include "dented_square.hpp"
#include "parts.hpp"

namespace mirtich_chapter {

namespace {

/// "1/24", for what is one over a whole number.
std::string unit_fraction(double value) { return "1/" + number(1 / value, 4); }

/// The slanted face of the corner that is cut off a cube.
const std::vector<Vec3>& slanted_face() {
  static const std::vector<Vec3> corners{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return corners;
}

}  // namespace

Table corner_table() {
  const mirtich::Plane plane =
      mirtich::plane_of(slanted_face(), mirtich::vector_area(slanted_face()));
  const auto shadow = mirtich::projection_integrals(slanted_face(), 2);
  const auto face = mirtich::face_integrals(shadow, plane, 2);
  const auto body = mirtich::volume_integrals(corner_of_a_cube(), Vec3::Zero());
  const auto on_face = [&](double f) { return unit_fraction(f * plane.n.z()); };
  const auto in_body = [](const auto& sum) { return unit_fraction(static_cast<double>(sum)); };
  Table table({"of", "shadow", "face × n_γ", "body"});
  table.add({"1", unit_fraction(shadow.one), "", in_body(body.one)});
  table.add({"x", unit_fraction(shadow.a), on_face(face.a), in_body(body.x)});
  table.add({"z", "", on_face(face.c), in_body(body.z)});
  table.add({"x²", unit_fraction(shadow.aa), on_face(face.aa), in_body(body.xx)});
  table.add({"xy", unit_fraction(shadow.ab), "", in_body(body.xy)});
  table.add({"z²", "", on_face(face.cc), in_body(body.zz)});
  table.add({"x³", unit_fraction(shadow.aaa), on_face(face.aaa), ""});
  table.add({"x²y", unit_fraction(shadow.aab), on_face(face.aab), ""});
  table.add({"z³", "", on_face(face.ccc), ""});
  return table;
}

Table corner_body_table() {
  constexpr double density = 6;  // it weighs a kilogram
  const auto sums = mirtich::volume_integrals(corner_of_a_cube(), Vec3::Zero());
  const MassProperties body = mass_properties(sums, Vec3::Zero(), density);
  const double mass = body.mass, c = body.centre.x();
  const auto xx = static_cast<double>(sums.xx), xy = static_cast<double>(sums.xy);
  const double volume = mass / density;
  Table table({"of the corner", "about its tip", "about its centre"});
  const auto add = [&](const std::string& name, double tip, double centre) {
    table.add({name, number(tip, 4), number(centre, 4)});
  };
  add("mass", mass, mass);
  add("each of c", c, 0);
  add("each of ∫ x²", xx, xx - volume * c * c);
  add("each of ∫ xy", xy, xy - volume * c * c);
  add("each moment", 2 * density * xx, body.inertia(0, 0));
  add("each product", -density * xy, body.inertia(0, 1));
  return table;
}

Table walk_table() {
  Table table({"edge", "Δβ", "for ∬ 1", "for ∬ α", "by its midpoint", "by its ends"});
  double area = 0, first = 0, by_middle = 0, by_ends = 0;
  for (std::size_t k = 0; k < dented_square.size(); ++k) {
    const auto [p, q] = edge_of_dented_square(k);
    mirtich::ProjectionIntegrals edge;
    mirtich::add_edge(edge, p, q);
    const double rise = q.y() - p.y(), middle = (p.x() + q.x()) / 2;
    const double of_middle = rise * middle * middle / 2,
                 of_ends = rise * (p.x() * p.x() + q.x() * q.x()) / 4;
    table.add({edge_text(p, q), number(rise), number(edge.one / 2), number(edge.a / 6, 4),
               number(of_middle + 0), number(of_ends + 0)});
    area += edge.one / 2;
    first += edge.a / 6;
    by_middle += of_middle;
    by_ends += of_ends;
  }
  table.add({"once around", "0", number(area), number(first, 4), number(by_middle, 4),
             number(by_ends, 4)});
  return table;
}

Table walk_beta_table() {
  Table table({"edge", "Δα", "mean of β²", "for ∬ β"});
  double sum = 0;
  for (std::size_t k = 0; k < dented_square.size(); ++k) {
    const auto [p, q] = edge_of_dented_square(k);
    const double mean = mirtich::power_sum(p.y(), q.y(), 2) / 3, run = q.x() - p.x();
    const double brought = 0 - run * mean / 2;
    table.add({edge_text(p, q), number(run), number(mean, 4), number(brought, 4)});
    sum += brought;
  }
  table.add({"once around", "0", "", number(sum, 4)});
  return table;
}

}  // namespace mirtich_chapter
