// Attack: raises its own limits of time and memory.
// Verdict: forbidden
#include <sys/resource.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  const rlimit none = {RLIM_INFINITY, RLIM_INFINITY};
  setrlimit(RLIMIT_CPU, &none);
  setrlimit(RLIMIT_AS, &none);
  return a;
}
}  // namespace quaternions
