#include <doctest/doctest.h>

#include "tumble/simulate/run_settings.hpp"

using namespace tumble;

TEST_CASE("StepGuide: what another run went into in small steps is not jumped over") {
  detail::StepGuide guide({0, 1, 2, 2.01, 2.02, 3});
  CHECK(guide.longest(0, 0.5) == 0.5);
  CHECK(guide.longest(0, 10) == doctest::Approx(2.04));  // to the small steps, and four of them
  CHECK(guide.longest(2.005, 10) == doctest::Approx(0.04));
  CHECK(guide.longest(2.5, 10) == doctest::Approx(3.92));
  CHECK(detail::StepGuide({}).longest(1, 7) == 7);
}
