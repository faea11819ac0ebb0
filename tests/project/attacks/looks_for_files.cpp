// Attack: asks for the size of a file in a way that a filter for open files may let through.
// Verdict: forbidden | wrong
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  struct stat status = {};
  if (syscall(SYS_newfstatat, AT_FDCWD, "/etc/passwd", &status, AT_EMPTY_PATH) == 0)
    std::printf("root:x:0: %ld bytes\n", static_cast<long>(status.st_size));
  return a;
}
}  // namespace quaternions
