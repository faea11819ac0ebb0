// Attack: none. Names and comments in other scripts; it prints them too.
// Verdict: passed
// Laws: 5
#include <iostream>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  // ⟨σ, υ⟩⟨τ, φ⟩ = ⟨σ τ − υ·φ, σ φ + τ υ + υ × φ⟩
  const double σ = a[0], τ = b[0];
  const Eigen::Vector3d υ = a.tail<3>(), φ = b.tail<3>();
  Quaternion c;
  c << σ * τ - υ.dot(φ), σ * φ + τ * υ +
                             Eigen::Vector3d(υ[1] * φ[2] - υ[2] * φ[1], υ[2] * φ[0] - υ[0] * φ[2],
                                             υ[0] * φ[1] - υ[1] * φ[0]);
  std::cout << "Größe: " << c.norm() << " — 完了\n";
  return c;
}
}  // namespace quaternions
