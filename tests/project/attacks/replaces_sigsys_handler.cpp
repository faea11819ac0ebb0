// Attack: takes the signal by which the sandbox reports, goes on after each refused call, and
//         prints what it could read.
// Verdict: wrong
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  std::signal(SIGSYS, [](int) {});
  char text[4096] = "";
  const int file = open("/etc/passwd", O_RDONLY);
  if (file > 3 && read(file, text, sizeof text - 1) > 0) std::puts(text);
  return a;
}
}  // namespace quaternions
