// Attack: a destructor throws while an exception is under way: std::terminate, past every catch.
// Verdict: crashed
#include <stdexcept>

namespace {
struct Bomb {
  ~Bomb() noexcept(false) { throw std::runtime_error("second"); }
};
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) {
  const Bomb bomb;
  throw std::runtime_error("first");
}
}  // namespace quaternions
