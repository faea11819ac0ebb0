// Attack: runs before every constructor, also before the worker's own first step, and ends the
//         process with success.
// Verdict: exited
#include <cstdlib>

static void first_of_all() { std::_Exit(0); }
__attribute__((section(".preinit_array"), used)) static void (*entry)() = first_of_all;

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
