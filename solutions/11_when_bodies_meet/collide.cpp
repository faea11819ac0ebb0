#include "contract.hpp"

namespace when_bodies_meet {

Eigen::Vector3d collide(const Eigen::Matrix3d& K, const Eigen::Vector3d& u,
                        const Eigen::Vector3d& n, double e) {
  const double u_n = u.dot(n);
  if (u_n >= 0) return Eigen::Vector3d::Zero();
  // j = −(1 + e) u_n / (n·K n)
  return -(1 + e) * u_n / n.dot(K * n) * n;
}

}  // namespace when_bodies_meet
