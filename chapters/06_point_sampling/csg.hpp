#pragma once
/// @file
/// Solids made of solids: a die with drilled pips, whose centre of mass is not in its middle, and a
/// mug that is cut open.

#include "portrait.hpp"

namespace point_sampling_chapter {

// ── A die, in millimetres ──

constexpr double die_edge = 16, die_ball = 11.2, pip = 1.6, pip_place = 4;  // [mm]

/// Half balls drilled into the faces: 1 on +z, 6 on −z, 2 on −y, 5 on +y, 3 on +x, 4 on −x. A solid
/// is whatever can say what it contains, and where it ends.
struct Pips {
  static bool contains(const Vec3& p) {
    return std::any_of(centres().begin(), centres().end(), [&p](const Vec3& centre) {
      return (p - centre).squaredNorm() <= pip * pip;
    });
  }
  static Eigen::AlignedBox3d bounds() {
    const Vec3 corner = Vec3::Constant(die_edge / 2 + pip);
    return {-corner, corner};
  }
  static const std::vector<Vec3>& centres();
};

/// The places of n pips on a face, in units of their distance from its middle.
inline std::vector<Vec2> pattern(int n) {
  std::vector<Vec2> places;
  if (n % 2 == 1) places.emplace_back(0, 0);
  for (const double s : {-1., 1.}) {
    if (n >= 2) places.emplace_back(s, s);
    if (n >= 4) places.emplace_back(s, -s);
    if (n == 6) places.emplace_back(s, 0);
  }
  return places;
}

inline const std::vector<Vec3>& Pips::centres() {
  static const std::vector<Vec3> list = [] {
    std::vector<Vec3> all;
    constexpr std::array<std::array<int, 2>, 3> numbers{{{3, 4}, {5, 2}, {1, 6}}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const std::size_t side : {0u, 1u})
        for (const Vec2& place : pattern(numbers[axis][side])) {
          Vec3 centre;
          centre[static_cast<int>(axis)] = (side == 0 ? 1 : -1) * die_edge / 2;
          centre[static_cast<int>(axis + 1) % 3] = pip_place * place.x();
          centre[static_cast<int>(axis + 2) % 3] = pip_place * place.y();
          all.push_back(centre);
        }
    return all;
  }();
  return list;
}

inline auto die() {
  const Box box{Vec3::Constant(die_edge)};
  return difference(intersection(box, Ball{die_ball}), Pips{});
}

/// Volume and centre of mass in closed form: a ball without six caps, without 21 half balls.
inline double die_volume() {
  const double r = die_ball, h = r - die_edge / 2;
  const double ball = 4 * pi / 3 * r * r * r, cap = pi * h * h * (3 * r - h) / 3;
  return ball - 6 * cap - 21 * (2 * pi / 3 * pip * pip * pip);
}
inline Vec3 die_centre() {
  const double half_ball = 2 * pi / 3 * pip * pip * pip, depth = die_edge / 2 - 3 * pip / 8;
  return half_ball * depth / die_volume() * Vec3(4 - 3, 2 - 5, 6 - 1);
}

inline std::string millimetres(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f mm", value);
  return text.data();
}

inline Table die_table() {
  Table table({"points", "z of the centre: random", "standard error", "R3", "closed form"});
  for (const int n : {1000, 10000, 100000, 1000000}) {
    const auto random = sample_mass_properties(die(), 1, RandomPoints(n, 2));
    const auto r3 = sample_mass_properties(die(), 1, R3Points(n));
    table.add({number(n, 7), millimetres(random.centre.z()),
               millimetres(random.centre_standard_error / std::sqrt(3.0)),
               millimetres(r3.centre.z()), millimetres(die_centre().z())});
  }
  return table;
}

// ── Pictures ──

inline std::string caption(double x, double y, const std::string& words) {
  return "<text x=\"" + support::svg_number(x) + "\" y=\"" + support::svg_number(y) +
         "\" fill=\"var(--ink)\" font-size=\"22\" text-anchor=\"middle\">" +
         support::svg_text(words) + "</text>\n";
}

inline std::string csg_figure() {
  constexpr int n = 96;
  constexpr double cell = 253, size = cell / n;
  std::string svg =
      support::svg_open(760, 300, "Solids made of solids, drawn by asking for points");
  const Mat3 from_above = axis_rotation(0, 0.45) * axis_rotation(0, -pi / 2);
  const auto draw = [&](int i, const auto& solid, const Mat3& R, const Vec3& middle, double half,
                        const std::string& words) {
    svg += shaded(DepthImage(solid, R, middle, half, n), n, {cell * i, 0}, size);
    svg += caption(cell * (i + 0.5), 284, words);
  };
  draw(0, intersection(Box{Vec3::Constant(die_edge)}, Ball{die_ball}),
       from_above * axis_rotation(2, -0.35), Vec3::Zero(), 12.5, "a box ∩ a ball …");
  draw(1, die(), from_above * axis_rotation(2, -0.35), Vec3::Zero(), 12.5, "… without 21 balls");
  const Eigen::AlignedBox3d box = mug_solid().bounds();
  const Placed<Box> knife =
      placed(Box{box.sizes()}, box.center() - Vec3(0, box.sizes().y() / 2, 0));
  draw(2, difference(mug_solid(), knife),
       axis_rotation(0, 0.45) * axis_rotation(0, -pi / 2) * axis_rotation(2, -0.35), box.center(),
       0.068, "a mesh without a box");
  return svg + "</svg>\n";
}

}  // namespace point_sampling_chapter
