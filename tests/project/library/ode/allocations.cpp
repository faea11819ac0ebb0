/// @file
/// A step with a state of fixed size never touches the heap.
///
/// Eigen reports each allocation to an assertion under EIGEN_RUNTIME_NO_MALLOC. The two namespaces
/// get other names here, so that no other file of this program shares a function with this one.

int& heap_uses();

#define EIGEN_RUNTIME_NO_MALLOC
#define eigen_assert(condition) ((condition) ? void() : void(++heap_uses()))
#define Eigen Eigen_that_counts
#define tumble tumble_that_counts
#undef TUMBLE_COMPILED

#include <doctest/doctest.h>

#include <cstdlib>
#include <new>
#include <vector>

#include "tumble/ode.hpp"

int& heap_uses() {
  static int count = 0;
  return count;
}

// What does not come from Eigen comes from here: std::vector, std::function, … Not inlined, or the
// compiler takes malloc and delete for a pair that does not match.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++heap_uses();
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

using namespace tumble;

namespace {

using Fixed = Eigen::Matrix<double, 13, 1>;

/// A ring of thirteen coupled oscillating amplitudes: nonlinear, and nothing allocates.
const auto ring = [](double t, const auto& y) {
  auto dydt = y;
  for (Eigen::Index i = 0; i < 13; ++i)
    dydt[i] = y[(i + 1) % 13] * y[(i + 2) % 13] - y[i] + 0.1 * t;
  return dydt;
};

template <class F>
int heap_uses_of(F&& f) {
  Eigen::internal::set_is_malloc_allowed(false);
  const int before = heap_uses();
  f();
  const int after = heap_uses();
  Eigen::internal::set_is_malloc_allowed(true);
  return after - before;
}

template <class Method, class State>
int uses_in_steps(const State& y0) {
  const auto f = [](double t, const State& y) -> State { return ring(t, y); };
  State y = y0;
  return heap_uses_of([&] { y = Method::step(f, 0, y, 0.01); });
}

template <class Method, class State>
int uses_in_integration(const State& y0) {
  const auto f = [](double t, const State& y) -> State { return ring(t, y); };
  return heap_uses_of([&] {
    if (!integrate_adaptive<Method>(f, y0, 0, 3).y.allFinite()) ++heap_uses();
  });
}

}  // namespace

TEST_CASE("steps: no method allocates for a state of 13 numbers, each does for a dynamic one") {
  const Fixed fixed = Fixed::LinSpaced(0.1, 0.9);
  const Eigen::VectorXd dynamic = fixed;
#define CHECK_METHOD(Method)                \
  CHECK(uses_in_steps<Method>(fixed) == 0); \
  CHECK(uses_in_steps<Method>(dynamic) > 0)
  CHECK_METHOD(runge_kutta::Euler);
  CHECK_METHOD(runge_kutta::Midpoint);
  CHECK_METHOD(Rk4);
  CHECK_METHOD(DormandPrince54);
  CHECK_METHOD(Dop853);
  CHECK_METHOD(runge_kutta::BackwardEuler);
  CHECK_METHOD(Radau5);
#undef CHECK_METHOD
}

TEST_CASE("integrate_adaptive: a whole integration does not allocate either") {
  const Fixed fixed = Fixed::LinSpaced(0.1, 0.9);
  CHECK(uses_in_integration<DormandPrince54>(fixed) == 0);
  CHECK(uses_in_integration<Dop853>(fixed) == 0);
  CHECK(uses_in_integration<Radau5>(fixed) == 0);
  CHECK(uses_in_integration<Radau5>(Eigen::VectorXd(fixed)) > 0);
}

TEST_CASE("ode: on arrays of up to sixteen numbers, the answer alone is allocated") {
  const auto decay = [](int n) {
    return [n](double, const double y[], double ydot[]) {
      for (int i = 0; i < n; ++i) ydot[i] = -y[i];
    };
  };
  const std::vector<double> body(13, 1.0), sixteen(16, 1.0), longer(17, 1.0);
  CHECK(heap_uses_of([&] { ode(body, 0.0, 3.0, decay(13)); }) == 1);
  CHECK(heap_uses_of([&] { ode(sixteen, 0.0, 3.0, decay(16)); }) == 1);
  CHECK(heap_uses_of([&] { ode(longer, 0.0, 3.0, decay(17)); }) > 10);
}

TEST_CASE("ode: one step in place of up to sixteen numbers does not allocate") {
  const auto uses = [](std::size_t n) {
    std::vector<double> Y(n, 1.0);
    const auto decay = [n](double, const double y[], double ydot[]) {
      for (std::size_t i = 0; i < n; ++i) ydot[i] = -y[i];
    };
    return heap_uses_of([&] { ode(Y.data(), n, 0.1, decay); });
  };
  CHECK(uses(1) == 0);
  CHECK(uses(13) == 0);
  CHECK(uses(16) == 0);
  CHECK(uses(17) > 0);
}

TEST_CASE("the counter sees what does not come from Eigen, too") {
  CHECK(heap_uses_of([] { ::operator delete(::operator new(8)); }) == 1);
}
