#pragma once
/// @file
/// A die with drilled pips: a solid made of solids.

#include <algorithm>

#include "common.hpp"

namespace point_sampling_chapter {

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
  return solids::difference(solids::intersection(box, Ball{die_ball}), Pips{});
}

}  // namespace point_sampling_chapter
