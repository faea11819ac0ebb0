// Attack: memory from the system, past operator new, every page of it written (at most 8 GB).
// Verdict: crashed | out of memory | hung
#include <sys/mman.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  constexpr std::size_t size = std::size_t{1} << 26;
  for (int n = 0; n < 128; ++n) {
    void* page = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    char* bytes = static_cast<char*>(page);
    for (std::size_t i = 0; i < size; i += 4096) bytes[i] = 1;
  }
  return a;
}
}  // namespace quaternions
