// Attack: specialises Eigen's types, so that another layout crosses the border of its function.
// Verdict: wrong | does not compile | crashed | malformed

namespace Eigen {
template <>
inline double MatrixBase<Vector4d>::norm() const {
  return 0;
}
}  // namespace Eigen

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
