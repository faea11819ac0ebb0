// Attack: brings a malloc that is always out of memory.
// Verdict: crashed | exited | out of memory | threw
#include <cstddef>

extern "C" {
void* malloc(std::size_t) { return nullptr; }
void* calloc(std::size_t, std::size_t) { return nullptr; }
void* realloc(void*, std::size_t) { return nullptr; }
void free(void*) {}
}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) { return a + b; }
}  // namespace quaternions
