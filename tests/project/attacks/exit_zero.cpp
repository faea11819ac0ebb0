// Attack: ends the process with "success" in the first call; a grader that looks at the exit status
//         of a test program sees no failure.
// Verdict: exited
#include <cstdlib>

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) { std::exit(0); }
}  // namespace quaternions
