/// @file
/// 1.1 carry: every type crosses the pipe unchanged, NaN and infinities too.
#include <cmath>
#include <limits>

#include "01_crossing/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using crossing::Luggage;

namespace student {
const Function<decltype(crossing::carry)> carry{TUMBLE_UNIT};
}

namespace {

Luggage any_luggage() {
  Luggage luggage{any_number(-1, 1), -7, true, "a, \"b\"\n\xc3\xa9", {}, {}};
  for (double& entry : luggage.matrix.reshaped()) entry = any_number(-1, 1);
  for (int i = 0; i < 3; ++i) luggage.points.push_back(any_vector());
  return luggage;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("anything comes back bit for bit") {
    const Luggage luggage = any_luggage();
    REQUIRE(student::carry(luggage) == close_to(luggage, 0));
  }

  TEST_CASE("NaN and infinities and the smallest numbers cross unchanged") {
    using limits = std::numeric_limits<double>;
    for (const double x : {limits::quiet_NaN(), limits::infinity(), -limits::infinity(),
                           limits::denorm_min(), limits::max(), -0.0}) {
      Luggage luggage = any_luggage();
      luggage.number = x;
      luggage.points[1].y() = x;
      const auto answer = student::carry(luggage);
      REQUIRE(answer == close_to(luggage, 0));
      REQUIRE(answer == obeys("the sign is kept",
                              std::signbit(answer->number) == std::signbit(x) ? 0 : 1, 0));
    }
  }

  TEST_CASE("empty lists and texts are still there") {
    Luggage luggage = any_luggage();
    luggage.label.clear();
    luggage.points.clear();
    REQUIRE(student::carry(luggage) == close_to(luggage, 0));
  }
}

const Misconceptions<decltype(crossing::carry)> misconceptions{
    TUMBLE_UNIT,
    {{"number lost", "The number is zero.", "",
      [](Luggage x) {
        x.number = 0;
        return x;
      }},
     {"count changed", "One was added.", "",
      [](Luggage x) {
        ++x.count;
        return x;
      }},
     {"label lost", "The label is empty.", "",
      [](Luggage x) {
        x.label.clear();
        return x;
      }},
     {"a point lost", "The last point is missing.", "", [](Luggage x) {
        if (!x.points.empty()) x.points.pop_back();
        return x;
      }}}};
