// Attack: returns another type.
// Verdict: does not compile

namespace quaternions {
Eigen::Vector3d product(const Quaternion& a, const Quaternion&) { return a.tail<3>(); }
}  // namespace quaternions
