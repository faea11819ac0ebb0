#include "tumble/collide/first_contact.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble;

TEST_CASE(
    "first_contact: within the tolerance at the end, above 0 before, and found if it is there") {
  test::Random rng(1121);
  for (int i = 0; i < 300; ++i) {
    const double a = rng.uniform(0.1, 3), phase = rng.uniform(0, 6), offset = rng.uniform(-1, 2);
    const double tolerance = std::pow(10, rng.uniform(-9, -2));
    double last = 0;
    const auto gap = [&](double t) { return last = t, offset + a * (1 + std::sin(t + phase)); };
    const auto contact = collide::first_contact(gap, a, 0, 20, tolerance);
    if (contact.found) CHECK((contact.t == last && contact.gap <= tolerance));
    CHECK(contact.found == (offset < tolerance || contact.gap <= tolerance));
    for (int k = 0; k < 1000; ++k) {
      const double t = contact.t * k / 1000;
      if (contact.t > 0) CHECK(gap(t) > -8 * test::eps * (std::abs(offset) + 2 * a));
    }
  }
}

TEST_CASE(
    "first_contact: 1e4 m/s against 1 mm, a start in touch, the end of the span, few queries") {
  // A ball of 1 mm flies through a plate of 1 mm, 5 km away.
  const auto gap = [](double t) { return std::abs(1e4 * t - 5e3) - 1e-3; };
  const auto fast = collide::first_contact(gap, 1e4, 0, 1e3, 1e-9);
  CHECK(fast.found);
  CHECK(std::abs(1e4 * fast.t - (5e3 - 1e-3)) < 1e-9);
  CHECK(fast.queries < 5);
  const auto touching = collide::first_contact([](double) { return 0.; }, 1, 3, 4, 1e-9);
  CHECK((touching.found && touching.t == 3 && touching.queries == 1));
  const auto parallel = collide::first_contact([](double) { return 0.1; }, 1, 0, 0.95, 1e-9);
  CHECK(!parallel.found);
  CHECK(parallel.t == 0.95);
  CHECK(parallel.queries == 10);
  // Nearer than t = 1e9 has digits for: said to touch, and no hang.
  const auto late = collide::first_contact([](double) { return 1e-12; }, 1, 1e9, 1e9 + 1, 1e-15);
  CHECK(late.found);
}

TEST_CASE("landing_time: the root of the quadratic without cancellation, and what never lands") {
  test::Random rng(1122);
  for (int i = 0; i < 10000; ++i) {
    const auto any = [&] { return std::pow(10, rng.uniform(-12, 6)); };
    const double h = any(), v = (i % 2 ? 1 : -1) * any(), a = -any();
    const long double lv = v, la = a, lh = h, root = std::sqrt(lv * lv - 2 * la * lh);
    const long double s = v > 0 ? (lv + root) / -la : 2 * lh / (root - lv);
    CHECK(std::abs(collide::landing_time(h, v, a) / static_cast<double>(s) - 1) < 8 * test::eps);
  }
  CHECK(collide::landing_time(0, 3, -2) == 3);   // it comes back
  CHECK(collide::landing_time(0, -3, -2) == 0);  // it lands at once
  CHECK(collide::landing_time(0, 0, -2) == 0);
  CHECK(collide::landing_time(-1e-17, 3, -2) == 3);
  CHECK(collide::landing_time(4, -1, 0) == 4);
  CHECK(std::isinf(collide::landing_time(4, 1, 0)));
  CHECK(std::isinf(collide::landing_time(4, -1, 1)));  // it turns round above the floor
  CHECK(collide::landing_time(1, -2, 2) == 1);         // it grazes
}

TEST_CASE("first_contact: what cannot be searched is refused") {
  const auto gap = [](double) { return 1.; };
  CHECK_REFUSED(collide::first_contact(gap, 0, 0, 1, 1e-9), "speed");
  CHECK_REFUSED(collide::first_contact(gap, 1, 1, 0, 1e-9), "span");
  CHECK_REFUSED(collide::first_contact(gap, 1, 0, 1, 0), "tolerance");
  CHECK_REFUSED(collide::first_contact([](double) { return NAN; }, 1, 0, 1, 1e-9), "NaN");
}
