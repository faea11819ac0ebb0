#include <doctest/doctest.h>

#include "project/library/contact/contact_scenes.hpp"

using namespace tumble;
using contact::ContactRun;
using contact::ContactScene;
using contact::Ending;
using test::box;
using test::down;

namespace {

/// Boxes over each other, with a gap below each. Each one is turned a little farther, and the
/// middle one spins.
ContactScene tower(int boxes, double gap, double e, double mu, double spin) {
  ContactScene scene{{}, {collide::HalfSpace{}}, down, e, mu};
  double z = 0;
  for (int i = 0; i < boxes; ++i) {
    const Vec3 size(0.5 + 0.1 * i, 0.8 - 0.1 * i, 0.4 + 0.05 * i);
    const Vec3 x(0.03 * i, -0.02 * i * i, z + gap + size.z() / 2);
    scene.bodies.push_back(box("box " + std::to_string(i), size, x,
                               exp_quaternion<double>(Vec3(0, 0, 0.05 * i)), Vec3::Zero(),
                               i == boxes / 2 ? Vec3(0, 0, spin) : Vec3(Vec3::Zero())));
    z += gap + size.z();
  }
  return scene;
}

}  // namespace

TEST_CASE("stacks: an impact costs the same, however long the run goes on") {
  const ContactScene scene = tower(3, 1e-4, 1, 0, 6);
  const auto queries = [&](double until) {
    const ContactRun run = simulate_contacts(scene, {.until = until, .max_impacts = 200});
    REQUIRE(run.ending == Ending::too_many_events);
    return run.queries;
  };
  MESSAGE(queries(2) << " distances of a run of 2 s, " << queries(2000) << " of one of 2000 s");
  CHECK(queries(2000) < 5 * queries(2) / 4);
}
