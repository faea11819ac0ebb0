// Attack: none. Throws and catches exceptions of its own, through several functions.
// Verdict: passed
// Laws: 5
#include <stdexcept>

namespace {
double entry(const Eigen::Vector4d& q, int i) {
  if (i > 3) throw std::out_of_range("a quaternion has four entries");
  return q[i];
}
int entries(const Eigen::Vector4d& q) {
  int count = 0;
  try {
    while (true) entry(q, count++);
  } catch (const std::out_of_range&) {
    return count - 1;
  }
}
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  if (entries(a) != entries(b)) throw std::logic_error("these are no quaternions");
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}
}  // namespace quaternions
