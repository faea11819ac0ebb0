// Attack: the resolver of an indirect function runs while the program is being relocated, before
//         anything else; it ends the process with success.
// Verdict: exited
#include <unistd.h>

extern "C" {
void nothing() {}
__attribute__((used)) void (*resolve(void))(void) {
  _exit(0);
  return nothing;
}
void chosen(void) __attribute__((ifunc("resolve")));
}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  chosen();
  return a;
}
}  // namespace quaternions
