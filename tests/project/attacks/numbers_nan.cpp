// Attack: answers NaN: no comparison with it is ever true, so the error is never larger than the
//         bound.
// Verdict: wrong

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  return (a + b) * std::numeric_limits<double>::quiet_NaN();
}
}  // namespace quaternions
