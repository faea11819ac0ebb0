// Attack: answers wrongly, and turns the exit status into success when the process ends: by atexit,
//         by at_quick_exit and by a destructor.
// Verdict: wrong
#include <cstdlib>

namespace {
void succeed() { std::_Exit(0); }
struct Late {
  ~Late() { succeed(); }
} late;
const int registered = std::atexit(succeed) + std::at_quick_exit(succeed);
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a * (1 + registered); }
}  // namespace quaternions
