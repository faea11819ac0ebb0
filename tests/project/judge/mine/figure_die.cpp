/// @file
/// The die of figure 11.9 by the solutions, over all that a reader can set.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "11_when_bodies_meet/readers_die.hpp"
#include "judge/page/student/figure_die.hpp"
#include "tumble/contact/simulate_contacts.hpp"

using namespace tumble;
using namespace contact_chapter;

namespace {

constexpr double until = 1;

contact::ContactScene thrown(double along, double up, double spin, double e) {
  return scene_of_die(objects::die_in_hand({along, 0, up}, {10, 2 * std::numbers::pi * spin, 4}), e,
                      0);
}

/// What the figure draws.
Throw by_solutions(const contact::ContactScene& scene) {
  const std::vector<double> question = question_of_die(scene, until);
  return readers_die(scene, until, judge::figure::die(judge::figure::Numbers(question)));
}

}  // namespace

TEST_CASE(
    "a reader's die: over all settings it stays on the table, and keeps what it has to keep") {
  int whole = 0, all = 0;
  for (const double along : {0., 0.4, 0.8})
    for (const double up : {-0.6, 0., 0.6})
      for (const double spin : {-15., -3., 0., 9.5, 15.})
        for (const double e : {0.1, 0.4, 0.7}) {
          CAPTURE(along);
          CAPTURE(up);
          CAPTURE(spin);
          CAPTURE(e);
          const contact::ContactScene scene = thrown(along, up, spin, e);
          const Throw own = by_solutions(scene);
          const RigidBodyState<>& start = scene.body(0).start;
          double before = energy_of_die(start);
          const double room = 1e-12 * before;
          for (const contact::FlightStart& leg : own.legs()) {
            CHECK(energy_of_die(leg.state) <= before + room);
            before = energy_of_die(leg.state);
            CHECK((leg.state.P - start.P).head<2>().norm() <= 1e-12 * start.P.norm());
          }
          for (int k = 0; k <= 100; ++k) CHECK(lowest_corner(own.at(own.end() * k / 100)) > -1e-10);
          ++all;
          if (own.run.ending == contact::Ending::time) ++whole;
          CHECK(own.end() > 0.4);
        }
  CHECK(50 * (all - whole) <= all);
}

TEST_CASE("a reader's die: its first impacts are the library's") {
  const contact::ContactScene scene = thrown(0.5, 0.4, 3, 0.6);
  const Throw own = by_solutions(scene);
  const contact::ContactRun run = contact::simulate_contacts(scene, {.until = 0.4});
  REQUIRE(run.impacts.size() == 4);
  // Each is found to 1e-8 m, and each magnifies the error.
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(std::abs(own.run.impacts.at(i).t - run.impacts[i].t) < 1e-4);
  CHECK(std::abs(own.run.impacts[0].t - run.impacts[0].t) < 1e-8);
}

TEST_CASE("a reader's die: what is no motion is not drawn") {
  const contact::ContactScene scene = thrown(0.5, 0.4, 3, 0.6);
  std::vector<double> answer =
      judge::figure::die(judge::figure::Numbers(question_of_die(scene, until)));
  const Throw right = readers_die(scene, until, answer);
  answer.resize(14 * 3);  // as if it fell through the table from then on
  CHECK(readers_die(scene, until, answer).end() == right.run.impacts[2].t);
  answer[14] = 1e300;
  CHECK(readers_die(scene, until, answer).end() == right.run.impacts[0].t);
  CHECK(readers_die(scene, until, {}).end() == 0);
}
