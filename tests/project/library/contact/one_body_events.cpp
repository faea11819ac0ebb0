#include "11_when_bodies_meet/one_body_events.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "project/harness/inputs.hpp"
#include "project/library/contact/contact_scenes.hpp"

using namespace tumble;
using contact::ContactRun;
using contact::ContactScene;

TEST_CASE("one body's events: a die that is thrown meets the floor as in simulate_contacts") {
  test::Random rng(30);
  for (int i = 0; i < 20; ++i) {
    const ContactScene scene = test::over_floor(
        test::box("die", Vec3::Constant(0.016), {0, 0, rng.uniform(0.05, 0.1)}, rng.rotation(),
                  {rng.uniform(0, 1), 0, rng.uniform(-1, 1)}, 30 * rng.vector()),
        0.6, 0.4);
    const contact::ContactSettings settings{.until = 2, .hop = 1e-3};
    const ContactRun all = contact::simulate_contacts(scene, settings);
    const ContactRun one =
        contact::detail::ContactSimulation<contact_chapter::OneBodyEvents>(scene, settings).run();
    // A body touches within the tolerance, and comes with more than 0.1 m/s at first; each impact
    // makes the difference of what comes before it some ten times as large.
    double close = 10 * settings.tolerance / 0.1;
    for (std::size_t k = 0; k < 3; ++k, close *= 10) {
      CHECK(std::abs(one.impacts[k].t - all.impacts[k].t) < close);
      CHECK((one.impacts[k].impulse - all.impacts[k].impulse).norm() <
            close / 1e-3 * all.impacts[k].impulse.norm());
    }
    CHECK(one.ending == contact::Ending::all_at_rest);
    CHECK(std::abs(test::balance(one.energy)) < 1e-12 * one.energy.start);
  }
}
