// Attack: leaves by _exit: no destructor runs, nothing is flushed, the status is 0.
// Verdict: exited
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) { _exit(0); }
}  // namespace quaternions
