// Attack: maps memory that can be executed, and runs machine code that it put there.
// Verdict: forbidden
#include <sys/mman.h>

#include <cstring>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  void* const page =
      mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  std::memset(page, 0xc3, 4096);
  reinterpret_cast<void (*)()>(page)();
  return a;
}
}  // namespace quaternions
