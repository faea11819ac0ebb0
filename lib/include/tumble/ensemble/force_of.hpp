#pragma once
/// @file
/// Which force acts on which body of an ensemble: one for all, or each its own.

#include <algorithm>
#include <span>

#include "tumble/body/forces.hpp"
#include "tumble/core/require.hpp"

namespace tumble::ensemble {

/// @addtogroup ensemble
/// @{

/// A force for each body, in their order: `PerBody<BodyDrag>{drags}`. Not copied.
template <class Force>
struct PerBody {
  std::span<const Force> forces;
};
template <class Range>
PerBody(const Range&) -> PerBody<typename Range::value_type>;

/// @}

}  // namespace tumble::ensemble

namespace tumble::detail::ensembles {

/// Force i of a PerBody; lanes behind the last body have the last one.
template <class Force>
const Force& force_of(const ensemble::PerBody<Force>& each, std::size_t i) {
  return each.forces[std::min(i, each.forces.size() - 1)];
}
template <class Force>
const Force& force_of(const Force& all, std::size_t) {
  return all;
}

/// @throws std::invalid_argument as require_valid_force() does, saying which body the force is for
template <class Force>
void require_valid_force_on(std::size_t body, const Force& force) {
  detail::require_at([&] { require_valid_force(force); }, "force on body ", body, ": ");
}

/// @throws std::invalid_argument if a force refuses what it is made of, or there is not one for
///         each body
template <class Force>
void require_valid_forces(const ensemble::PerBody<Force>& each, std::size_t bodies) {
  require(each.forces.size() == bodies, "there are ", each.forces.size(), " forces for ", bodies,
          " bodies");
  for (std::size_t i = 0; i < bodies; ++i) require_valid_force_on(i, each.forces[i]);
}
template <class Force>
void require_valid_forces(const Force& all, std::size_t) {
  require_valid_force(all);
}

}  // namespace tumble::detail::ensembles
