// Attack: defines a template, which nobody instantiates.
// Verdict: wrong signature

namespace quaternions {
template <class T>
T product(const T& a, const T& b) {
  return a + b;
}
}  // namespace quaternions
