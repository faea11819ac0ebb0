// Attack: leaves by quick_exit, past every atexit handler that a grader may rely on.
// Verdict: exited
#include <cstdlib>

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) { std::quick_exit(0); }
}  // namespace quaternions
