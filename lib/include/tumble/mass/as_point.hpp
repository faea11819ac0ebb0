#pragma once
/// @file
/// Writing a vector into a message: "(1, 2.5, -3)".

#include <ostream>

#include "tumble/core/types.hpp"

namespace tumble::detail {

/// Streams a vector as "(x, y, z)"; nothing is done unless it is streamed.
struct AsPoint {
  const Vec3& v;
  friend std::ostream& operator<<(std::ostream& out, const AsPoint& point) {
    return out << "(" << point.v.x() << ", " << point.v.y() << ", " << point.v.z() << ")";
  }
};

}  // namespace tumble::detail
