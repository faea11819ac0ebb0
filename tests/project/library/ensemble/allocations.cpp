/// @file
/// Steps of an ensemble never touch the heap.

#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "scenes.hpp"

namespace {

std::atomic<int> heap_uses = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++heap_uses;
  if (void* memory = std::aligned_alloc(alignment, (size + alignment) / alignment * alignment))
    return memory;
  throw std::bad_alloc();
}

}  // namespace

// Not inlined, or the compiler takes malloc and delete for a pair that does not match.
[[gnu::noinline]] void* operator new(std::size_t size) { return counted(size, 16); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

using namespace tumble;

TEST_CASE("advance: no heap, whatever the method and the forces") {
  const test::Bodies all = test::random_bodies(100, 3, 661);
  Ensemble ensemble = all.ensemble();
  const std::vector<BodyDrag> drags(all.size(), BodyDrag{0.1, 0.2});
  const ForceAtBodyPoint pull{Vec3(0, 0, -1), Vec3(0.1, 0, 0)};
  const auto uses = [&]<class Method>(Method, const auto&... forces) {
    const int before = heap_uses;
    const std::size_t lost = advance<Method>(ensemble, {0.01, 10}, forces...).count;
    return heap_uses - before + static_cast<int>(lost);
  };
  CHECK(uses(Rk4{}) == 0);
  CHECK(uses(TaylorMagnus<4>{}, Weight{}, pull) == 0);
  CHECK(uses(TaylorMagnus<8>{}, Weight{}, pull, ensemble::PerBody{drags}) == 0);
  CHECK(uses(Rk4{}, test::Tether{}, ensemble::PerBody{drags}) == 0);
}

TEST_CASE("the counter sees an ensemble being made") {
  const int before = heap_uses;
  const Ensemble ensemble = test::random_bodies(3, 1, 662).ensemble();
  CHECK(heap_uses - before >= 4);
}
