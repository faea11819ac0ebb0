// expect: wrong | named scatter about the origin
// 1 / n is a quotient of whole numbers: the mean is 0.
#include "contract.hpp"

namespace bounding_boxes {

namespace {

Eigen::Vector3d mean(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point;
  return 1 / points.size() * sum;
}

}  // namespace

Box fit_oriented_box(const std::vector<Eigen::Vector3d>& points) {
  const Eigen::Vector3d c = mean(points);
  // S = Σ (p − c)(p − c)ᵀ
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) S += (p - c) * (p - c).transpose();
  const Eigen::Matrix3d R = principal_axes(S);

  // Seen from the mean, along the axes of the box, it is the upright box of 7.1.
  std::vector<Eigen::Vector3d> turned;
  for (const Eigen::Vector3d& p : points) turned.push_back(R.transpose() * (p - c));
  const Box upright = bounding_box(turned);
  return {c + R * upright.centre, R, upright.size};
}

}  // namespace bounding_boxes
