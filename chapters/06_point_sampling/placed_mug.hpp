#pragma once
/// @file
/// The mug in orientations and places that have nothing to do with a grid.

#include <numbers>
#include <vector>

#include "objects/objects.hpp"
#include "support/random.hpp"
#include "tumble/rotation/exp.hpp"

namespace point_sampling_chapter {

using namespace tumble;

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// The mug of chapter 3: stoneware, 5232 triangles.
inline constexpr double mug_density = objects::stoneware;
inline const PolygonMesh& mug() {
  static const PolygonMesh mesh = objects::mug(2);
  return mesh;
}

/// Relative, by the root of the sum of the squares of all nine numbers.
inline double inertia_error(const Mat3& I, const Mat3& truth) {
  return (I - truth).norm() / truth.norm();
}

/// Orientations and places that have nothing to do with a grid, the same in every run.
struct Placement {
  Mat3 R;
  Vec3 x;
};

inline std::vector<Placement> placements(int count) {
  support::Random random(6);
  std::vector<Placement> list;
  for (int i = 0; i < count; ++i) {
    const Vec3 turn = random.vector(pi);
    list.push_back({exp_rotation(turn), random.vector(1)});
  }
  return list;
}

/// The mesh, turned and moved.
inline PolygonMesh placed_mesh(PolygonMesh mesh, const Placement& at) {
  for (Vec3& v : mesh.vertices) v = at.x + at.R * v;
  return mesh;
}

}  // namespace point_sampling_chapter
