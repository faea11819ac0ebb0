// Attack: moves a page to the address that the sandbox uses for paths.
// Verdict: forbidden
#include <sys/mman.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  void* const wanted = reinterpret_cast<void*>(std::uintptr_t{1} << 40);
  void* const page =
      mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  mremap(page, 4096, 4096, MREMAP_MAYMOVE | MREMAP_FIXED, wanted);
  return a;
}
}  // namespace quaternions
