#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/simulate/motion_difference.hpp"

namespace tumble::detail {

TUMBLE_BODY double difference_of_body(const PackedState<double>& a, const PackedState<double>& b,
                                      const Eigen::Vector4d& per_size) {
  const Eigen::Vector4d p = a.segment<4>(3).normalized(), q = b.segment<4>(3).normalized();
  const double angle = 2 * (p.dot(q) < 0 ? Eigen::Vector4d(p + q) : Eigen::Vector4d(p - q)).norm();
  const PackedState<double> off = a - b;
  return largest({angle, per_size[0] * off.head<3>().norm(), per_size[2] * off.segment<3>(7).norm(),
                  per_size[3] * off.tail<3>().norm() + angle});
}

}  // namespace tumble::detail
