// Attack: breaks a rule of Eigen, which asserts.
// Verdict: crashed

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const Eigen::VectorXd longer = Eigen::VectorXd::Zero(5);
  return a + b + longer;
}
}  // namespace quaternions
