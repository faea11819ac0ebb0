// expect: wrong | named never set | may be named not a number
// The sums were never set to 0.
#include <cstddef>

#include "contract.hpp"

namespace mirtich {

namespace {

/// The area of a polygon times its normal. What a dent takes away has the opposite direction.
Eigen::Vector3d vector_area(const std::vector<Eigen::Vector3d>& corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k)
    sum += rotation_matrices::skew(corners[k - 1] - corners[0]) * (corners[k] - corners[0]);
  return sum / 2;
}

/// What one face brings.
VolumeIntegrals of_face(const std::vector<Eigen::Vector3d>& corners) {
  VolumeIntegrals v{0, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const Eigen::Vector3d area = vector_area(corners);
  if (area.isZero(0)) return v;

  const Eigen::Vector3d n = area.normalized();
  const Plane plane{n, -n.dot(corners[0])};
  // Along the axis that is nearest to n the shadow is largest, and nothing is divided by 0.
  int C = 0;
  n.cwiseAbs().maxCoeff(&C);
  const int A = (C + 1) % 3, B = (C + 2) % 3;
  const FaceIntegrals f = face_integrals(projection_integrals(corners, C), plane, C);

  // ∫ dV = ⅓ ∬ n · r dA
  v.one = (n[A] * f.a + n[B] * f.b + n[C] * f.c) / 3;
  // ∫ x dV = ½ ∬ n_x x² dA
  v.r[A] = n[A] * f.aa / 2;
  v.r[B] = n[B] * f.bb / 2;
  v.r[C] = n[C] * f.cc / 2;
  // ∫ x² dV = ⅓ ∬ n_x x³ dA
  v.squares[A] = n[A] * f.aaa / 3;
  v.squares[B] = n[B] * f.bbb / 3;
  v.squares[C] = n[C] * f.ccc / 3;
  // ∫ x y dV = ½ ∬ n_x x² y dA
  v.products[A] = n[A] * f.aab / 2;
  v.products[B] = n[B] * f.bbc / 2;
  v.products[C] = n[C] * f.cca / 2;
  return v;
}

}  // namespace

VolumeIntegrals volume_integrals(const Polyhedron& body) {
  VolumeIntegrals sum;
  for (const std::vector<int>& face : body.faces) {
    std::vector<Eigen::Vector3d> corners;
    for (const int vertex : face)
      corners.push_back(body.vertices[static_cast<std::size_t>(vertex)]);
    const VolumeIntegrals v = of_face(corners);
    sum.one += v.one;
    sum.r += v.r;
    sum.squares += v.squares;
    sum.products += v.products;
  }
  return sum;
}

}  // namespace mirtich
