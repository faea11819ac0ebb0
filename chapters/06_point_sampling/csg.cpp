/// @file
/// Solids made of solids: a die with drilled pips, whose centre of mass is not in its middle, and a
/// mug that is cut open.

#include "common.hpp"
#include "die.hpp"
#include "parts.hpp"
#include "portrait.hpp"

namespace point_sampling_chapter {

// ── A die, in millimetres ──

namespace {

/// Volume and centre of mass in closed form: a ball without six caps, without 21 half balls.
double die_volume() {
  const double r = die_ball, h = r - die_edge / 2;
  const double ball = 4 * pi / 3 * r * r * r, cap = pi * h * h * (3 * r - h) / 3;
  return ball - 6 * cap - 21 * (2 * pi / 3 * pip * pip * pip);
}
Vec3 die_centre() {
  const double half_ball = 2 * pi / 3 * pip * pip * pip, depth = die_edge / 2 - 3 * pip / 8;
  return half_ball * depth / die_volume() * Vec3(4 - 3, 2 - 5, 6 - 1);
}

std::string millimetres(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f mm", value);
  return text.data();
}

}  // namespace

Table die_table() {
  Table table({"points", "z of the centre: random", "standard error", "R3", "closed form"});
  for (const int n : {1000, 10000, 100000, 1000000}) {
    const auto random = sampling::sample_mass_properties(die(), 1, sampling::RandomPoints(n, 2));
    const auto r3 = sampling::sample_mass_properties(die(), 1, sampling::R3Points(n));
    table.add({number(n, 7), millimetres(random.centre.z()),
               millimetres(random.centre_standard_error / std::sqrt(3.0)),
               millimetres(r3.centre.z()), millimetres(die_centre().z())});
  }
  return table;
}

// ── Pictures ──

namespace {

std::string caption(double x, double y, const std::string& words) {
  return "<text x=\"" + support::svg_number(x) + "\" y=\"" + support::svg_number(y) + "\" " +
         support::fill_of("ink") + " font-size=\"22\" text-anchor=\"middle\">" +
         support::svg_text(words) + "</text>\n";
}

}  // namespace

std::string csg_figure() {
  constexpr int n = 150;
  constexpr double cell = 253, size = cell / n;
  std::string svg =
      support::svg_open(760, 300, "Solids made of solids, drawn by asking for points");
  const Mat3 from_above = axis_rotation(0, 0.45) * axis_rotation(0, -pi / 2);
  const auto draw = [&](int i, const auto& solid, const Mat3& R, const Vec3& middle, double half,
                        const std::string& words) {
    svg += shaded(DepthImage(solid, R, middle, half, n), n, {cell * i, 0}, size);
    svg += caption(cell * (i + 0.5), 284, words);
  };
  draw(0, solids::intersection(Box{Vec3::Constant(die_edge)}, Ball{die_ball}),
       from_above * axis_rotation(2, -0.35), Vec3::Zero(), 12.5, "a box ∩ a ball …");
  draw(1, die(), from_above * axis_rotation(2, -0.35), Vec3::Zero(), 12.5, "… without 21 balls");
  const Eigen::AlignedBox3d box = mug_solid().bounds();
  const solids::Placed<Box> knife =
      solids::placed(Box{box.sizes()}, box.center() - Vec3(0, box.sizes().y() / 2, 0));
  draw(2, solids::difference(mug_solid(), knife),
       axis_rotation(0, 0.45) * axis_rotation(0, -pi / 2) * axis_rotation(2, -0.35), box.center(),
       0.068, "a mesh without a box");
  return svg + "</svg>\n";
}

}  // namespace point_sampling_chapter
