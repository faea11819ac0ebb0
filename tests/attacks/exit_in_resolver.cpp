// Attack: the resolver of an indirect function runs while the program is being relocated, before
//         anything else; it ends the process with success.
// Verdict: exited
#include <sys/syscall.h>
#include <unistd.h>

static void nothing() {}
extern "C" {
static void (*resolve())() {
  _exit(0);
  return nothing;
}
void chosen() __attribute__((ifunc("_ZL7resolvev")));
}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  chosen();
  return a;
}
}  // namespace quaternions
