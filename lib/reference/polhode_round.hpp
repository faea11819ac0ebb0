#pragma once
/// @file
/// The way of L in a free body's own axes, once round.

#include <cmath>
#include <vector>

#include "tumble/elliptic/integrals.hpp"
#include "tumble/free_body/free_trajectory.hpp"

namespace tumble::reference {

/// Points of the way that begins at a direction of L, `count` of them a round and the first once
/// more, at equal times.
/// @param moments   principal moments, ascending and different
/// @param direction of L in the body's axes, not on the way that parts the others
/// @param late      by which part of a step the points come later than that, so that none lies on a
///                  plane of symmetry
inline std::vector<Vec3> polhode_round(const Vec3& moments, const Vec3& direction, int count,
                                       double late = 0) {
  const RigidBody<> body(1, moments.asDiagonal());
  const RigidBodyState<> start{Vec3::Zero(), Quat::Identity(), Vec3::Zero(), direction};
  const auto polhode = elliptic::polhode_of(principal_axes(body.I_body()), start.q, start.L);
  const double round = 4 * elliptic::complete_elliptic_k(std::sqrt(polhode->modulus.kc2)) /
                       std::abs(polhode->lambda);
  const FreeTrajectory motion(body, start);
  std::vector<Vec3> points;
  for (int i = 0; i <= count; ++i) {
    const Quat q = motion.at(round * (i + late) / count).q;
    points.push_back(to_matrix(q).transpose() * direction);
  }
  return points;
}

}  // namespace tumble::reference
