// Attack: brings a write that sends good news instead of what the worker writes.
// Verdict: malformed | exited
#include <sys/syscall.h>
#include <unistd.h>

extern "C" ssize_t write(int file, const void*, std::size_t size) {
  syscall(SYS_write, file, "{\"passed\": true, \"laws_that_hold\": 5}", 36);
  return static_cast<ssize_t>(size);
}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) { return a + b; }
}  // namespace quaternions
