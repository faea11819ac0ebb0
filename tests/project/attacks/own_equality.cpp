// Attack: overloads comparisons so that everything is equal to everything; it works where the
//         test's == finds them.
// Verdict: wrong

namespace Eigen {
template <class T>
bool operator==(const MatrixBase<T>&, const Vector4d&) {
  return true;
}
}  // namespace Eigen
namespace quaternions {
bool operator==(const Quaternion&, double) { return true; }
double norm(const Quaternion&) { return 0; }
}  // namespace quaternions

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) { return a + b; }
}  // namespace quaternions
