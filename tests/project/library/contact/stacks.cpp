#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
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

TEST_CASE("stacks: one box that slides under another one ends in contact that lasts, and soon") {
  test::Random rng(2);  // two of these ran into any limit of impacts
  const auto still = [](const char* name, const Vec3& size, const Vec3& x) {
    return box(name, size, x, Quat::Identity(), Vec3::Zero(), Vec3::Zero());
  };
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    const Vec3 lower = Vec3(0.263, 0.937, 0.909) + rng.vector(0, 1e-3);
    const Vec3 upper = Vec3(0.39, 0.312, 0.914) + rng.vector(0, 1e-3);
    const Vec3 x(-0.012, 0.003, 0.001 + lower.z() / 2);
    const Vec3 above(0.0033, 0.0043, 0.001 + (lower.z() + upper.z()) / 2);
    const ContactScene scene{{still("lower", lower, x), still("upper", upper, x + above)},
                             {collide::HalfSpace{}},
                             down,
                             0.9,
                             0.1};
    const ContactRun run = simulate_contacts(scene, {.until = 3, .max_impacts = 1500});
    CHECK(run.ending == Ending::lasting_contact);
  }
}

TEST_CASE("stacks: bounces with e = 1 that friction takes away end in contact that lasts") {
  const Vec3 size(0.41, 0.99, 0.82), above(0, 0, 2e-6 + size.z() / 2);
  const auto scene = test::over_floor(box("box", size, above, from_axis_angle(Vec3::UnitX(), 1e-6),
                                          Vec3(0.73, 0, 0), Vec3(0, 0, 0.334)),
                                      1, 0.5);
  const ContactRun run =
      simulate_contacts(scene, {.until = 1, .tolerance = 1e-6, .max_impacts = 4000});
  CHECK(run.ending == Ending::lasting_contact);
}
