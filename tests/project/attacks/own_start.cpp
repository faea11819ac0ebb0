// Attack: brings the first function of every program.
// Verdict: wrong | exited
#include <unistd.h>

extern "C" void _start() { _exit(0); }

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) { return a + b; }
}  // namespace quaternions
