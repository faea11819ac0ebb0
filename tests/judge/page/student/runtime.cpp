/// @file
/// What a student's module has beside the worker: what its C++ library leaves out. That library is
/// built without exceptions; the rest of them comes from libc++abi's own sources
/// (build/runtime.mjs).

#include <cstdlib>
#include <ctime>
#include <new>

// The tag that every C++ exception of this module is thrown with.
__asm__(
    ".tagtype __cpp_exception i32\n"
    ".globl __cpp_exception\n"
    "__cpp_exception:\n");

// Exceptions live in memory of malloc's: where that is used up, there is none in reserve.
namespace __cxxabiv1 {

void* __malloc_with_fallback(std::size_t size) { return std::malloc(size); }
void* __calloc_with_fallback(std::size_t count, std::size_t size) {
  return std::calloc(count, size);
}
void* __aligned_malloc_with_fallback(std::size_t size) {
  constexpr std::size_t alignment = 16;
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
void __free_with_fallback(void* memory) { std::free(memory); }
void __aligned_free_with_fallback(void* memory) { std::free(memory); }

}  // namespace __cxxabiv1

// The library's own ends the program where there is no memory.
void* operator new(std::size_t size) {
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return ::operator new(size); }

// A trap would look like any other; who runs the module can tell this one.
extern "C" {
[[noreturn, clang::import_module("tumble"), clang::import_name("abort")]] void tumble_abort();
void abort() { tumble_abort(); }
// There are no processes, and so no time of one.
std::clock_t clock() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  constexpr long long per_second = 1000000000;
  return now.tv_sec * CLOCKS_PER_SEC + now.tv_nsec / (per_second / CLOCKS_PER_SEC);
}
}
