#pragma once
/// @file
/// A body of the contest as the library's own.

#include "project/bench/dynamics/contest.hpp"
#include "tumble/body/derived.hpp"

namespace tumble::bench {

/// Of mass 1: nothing depends on it.
inline RigidBody<> rigid_body(const Body& body) { return {1, body.moments.asDiagonal()}; }

/// How it starts, its centre at rest in the origin.
inline RigidBodyState<> start_of(const Body& body) {
  const auto& [q, omega] = body.start;
  return state_of_motion<double>(rigid_body(body), Vec3::Zero(), q, Vec3::Zero(), q * omega);
}

}  // namespace tumble::bench
