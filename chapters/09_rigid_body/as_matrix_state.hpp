#pragma once
/// @file
/// A state with nine numbers for the orientation.

#include "common.hpp"
#include "tumble/body/matrix_state.hpp"

namespace rigid_body_chapter {

inline rotation::MatrixState<> as_matrix_state(const RigidBodyState<>& s) {
  return {s.x, to_matrix(s.q), s.P, s.L};
}

}  // namespace rigid_body_chapter
