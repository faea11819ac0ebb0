#pragma once
/// @file
/// The right-hand side of a problem's motion, in any scalar.

#include "judge/mine/problem.hpp"

namespace tumble::judge::mine {

/// Calls `action` with the right-hand side of the problem's motion, in the scalar T.
template <class T, class Action>
auto with_motion(const Problem& problem, Action&& action) {
  const RigidBody<T> body(problem.exact);
  using End = decltype(action(RigidBodyRhs(body)));
  if (!problem.pull) return action(RigidBodyRhs(body));
  return End(action(RigidBodyRhs(body, Weight{problem.pull->gravity}, problem.pull->spring)));
}

}  // namespace tumble::judge::mine
