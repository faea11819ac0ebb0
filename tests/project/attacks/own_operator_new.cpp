// Attack: brings an operator new that gives everybody the same memory.
// Verdict: wrong | crashed | malformed | exited | hung | threw | out of memory
#include <cstdlib>
#include <new>

alignas(64) static char memory[1 << 20];
void* operator new(std::size_t) { return memory; }
void operator delete(void*) noexcept {}
void operator delete(void*, std::size_t) noexcept {}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) { return a + b; }
}  // namespace quaternions
