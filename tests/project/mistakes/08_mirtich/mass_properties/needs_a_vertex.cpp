// expect: threw
// The first vertex is read, also where there is none.
#include "contract.hpp"

namespace mirtich {

namespace {

/// The middle of the box around all vertices; there is at least one.
Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3d>& vertices) {
  Eigen::Vector3d low = vertices.at(0), high = low;
  for (const Eigen::Vector3d& x : vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (low + high) / 2;
}

/// ρ ∫ (rᵀr 1 − r rᵀ) dV
Eigen::Matrix3d inertia_of(const Eigen::Vector3d& squares, const Eigen::Vector3d& products,
                           double density) {
  const double xx = squares[0], yy = squares[1], zz = squares[2];
  const double xy = products[0], yz = products[1], zx = products[2];
  Eigen::Matrix3d I;
  // clang-format off
  I << yy + zz,     -xy,     -zx,
           -xy, zz + xx,     -yz,
           -zx,     -yz, xx + yy;
  // clang-format on
  return density * I;
}

}  // namespace

MassProperties mass_properties(const Polyhedron& body, double density) {
  const MassProperties nothing{0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};

  // About a point in the middle of the body all numbers are small, and nothing cancels.
  const Eigen::Vector3d p = middle_of(body.vertices);
  Polyhedron near = body;
  for (Eigen::Vector3d& x : near.vertices) x -= p;
  const VolumeIntegrals v = volume_integrals(near);
  if (v.one == 0) return nothing;

  // c = ∫ r dV / V, seen from p
  const Eigen::Vector3d c = v.r / v.one;
  // From p to the centre: ∫ x² dV − V c_x², ∫ x y dV − V c_x c_y
  const Eigen::Vector3d next_c(c.y(), c.z(), c.x());
  const Eigen::Vector3d squares = v.squares - v.one * c.cwiseProduct(c);
  const Eigen::Vector3d products = v.products - v.one * c.cwiseProduct(next_c);
  return {density * v.one, p + c, inertia_of(squares, products, density)};
}

}  // namespace mirtich
