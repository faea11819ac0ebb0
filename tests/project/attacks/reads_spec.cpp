// Attack: reads the spec with its misconceptions while it runs, by a call without a library.
// Verdict: forbidden
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  char text[8192];
  const long file =
      syscall(SYS_openat, AT_FDCWD, "@ROOT@/tests/04_quaternions/product.cpp", O_RDONLY);
  if (file < 0) return a;
  const auto size = read(static_cast<int>(file), text, sizeof text);
  if (write(1, text, static_cast<std::size_t>(size)) < 0) return a;
  return a;
}
}  // namespace quaternions
