#pragma once
/// @file
/// The family of shapes whose mass properties can be sampled: anything that can say "inside".

#include <concepts>

#include "tumble/core/types.hpp"

namespace tumble::solids {

/// @addtogroup core
/// @{

/// A shape that can tell whether a point [m] is inside it, and a box that surely holds all of it.
template <class S>
concept Solid = requires(const S& solid, const Vec3& point) {
  { solid.contains(point) } -> std::convertible_to<bool>;
  { solid.bounds() } -> std::convertible_to<Eigen::AlignedBox3d>;
};

/// @}

}  // namespace tumble::solids
