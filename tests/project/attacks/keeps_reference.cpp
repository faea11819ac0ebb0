// Attack: returns a reference to what is gone: through a pointer, so that no compiler warns.
// Verdict: wrong | crashed
#include <memory>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const Quaternion* gone = nullptr;
  {
    const auto sum = std::make_unique<Quaternion>(a + b);
    gone = sum.get();
  }
  return *gone;
}
}  // namespace quaternions
