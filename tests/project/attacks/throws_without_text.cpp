// Attack: an exception whose what() is a null pointer: to make a text of it is undefined.
// Verdict: crashed | threw
#include <exception>

namespace {
struct Silent : std::exception {
  const char* what() const noexcept override { return nullptr; }
};
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) { throw Silent{}; }
}  // namespace quaternions
