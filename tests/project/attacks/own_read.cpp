// Attack: brings a read that gives the worker questions of the student's choice.
// Verdict: crashed | malformed | exited
#include <unistd.h>

#include <cstring>

extern "C" ssize_t read(int, void* to, std::size_t size) {
  std::memset(to, 0, size);
  return static_cast<ssize_t>(size);
}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) { return a + b; }
}  // namespace quaternions
