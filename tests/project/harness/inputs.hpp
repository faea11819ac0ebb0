#pragma once
/// @file
/// The inputs that a law is tried on: the same on every platform, and always the awkward ones too.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "support/random.hpp"
#include "tumble/core/types.hpp"

namespace tumble::test {

/// Unit roundoff of double, 2⁻⁵³: tolerances are written as k·eps, k the number of roundings.
inline constexpr double eps = 0x1p-53;

using support::Random;

/// Rotation vectors θ u to try a law of rotations on: zero, tiny, random, near π and at π.
inline std::vector<Vec3> rotation_vectors(std::uint64_t seed = 1, int random = 200) {
  constexpr double pi = std::numbers::pi;
  std::vector<Vec3> list{Vec3::Zero()};
  Random rng(seed);
  for (const Vec3& axis :
       {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ()), rng.direction()}) {
    for (const double angle :
         {1e-300, 1e-16, 1e-8, 1e-4, pi / 2, pi - 1e-4, pi - 1e-8, pi - 1e-15, pi})
      list.push_back(angle * axis);
  }
  for (int i = 0; i < random; ++i) list.push_back(rng.uniform(0, pi) * rng.direction());
  return list;
}

}  // namespace tumble::test
