#include "tumble/contact/can_touch.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/contact/simulate_contacts.hpp"
#include "tumble/mass/solids/box.hpp"

using namespace tumble;
using contact::ContactBody;
using contact::ContactScene;

namespace {

const Vec3 falling(0, 0, -10);

ContactBody rod(const Vec3& x, const Vec3& v, const Vec3& omega = Vec3::Zero()) {
  const Vec3 size(0.2, 0.2, 2);
  const RigidBody<> body(mass_properties(Box{size}, 1000));
  return {"rod", body, collide::Convex::box(size),
          state_of_motion<double>(body, x, Quat::Identity(), v, omega)};
}

const double reach = std::sqrt(0.01 + 0.01 + 1);

ContactScene scene_of(std::vector<ContactBody> bodies) {
  return {std::move(bodies), {}, falling, 0.5, 0.3};
}

}  // namespace

TEST_CASE("can_touch: a body that falls reaches the floor when its ball does") {
  ContactScene scene = scene_of({rod(Vec3(0, 0, reach + 5), Vec3::Zero())});
  scene.walls = {collide::HalfSpace{}};
  CHECK_FALSE(can_touch(scene, 0));
  CHECK_FALSE(can_touch(scene, 1 - 1e-9));
  CHECK(can_touch(scene, 1 + 1e-9));
}

TEST_CASE("can_touch: a way that turns round before a wall, and one that reaches it in between") {
  // With 10 m/s it rises by 5 m, and is back after 2 s.
  ContactScene scene = scene_of({rod(Vec3::Zero(), Vec3(0, 0, 10))});
  const auto ceiling = [](double z) { return collide::HalfSpace{Vec3(0, 0, z), -Vec3::UnitZ()}; };
  scene.walls = {ceiling(reach + 5 + 1e-9)};
  CHECK_FALSE(can_touch(scene, 2));
  scene.walls = {ceiling(reach + 5 - 1e-9)};
  CHECK(can_touch(scene, 2));
  CHECK_FALSE(can_touch(scene, 0.9));
  // A wall to the side, without gravity along its normal.
  scene.bodies[0] = rod(Vec3::Zero(), Vec3(2, 0, 0));
  scene.walls = {{Vec3(reach + 4, 0, 0), -Vec3::UnitX()}};
  CHECK_FALSE(can_touch(scene, 2 - 1e-9));
  CHECK(can_touch(scene, 2 + 1e-9));
}

TEST_CASE("can_touch: bodies that fall alike meet as if nothing fell, few or many") {
  for (const int others : {0, 30}) {
    CAPTURE(others);
    const auto meets = [&](double beside, double until) {
      std::vector<ContactBody> bodies{rod(Vec3(-5, beside, 0), Vec3(1, 0, 3)),
                                      rod(Vec3(5, 0, 0), Vec3(-1, 0, 3))};
      for (int i = 0; i < others; ++i)
        bodies.push_back(rod(Vec3(100 + 10 * i, 50, 0), Vec3::Zero()));
      return can_touch(scene_of(bodies), until);
    };
    const double touch = 5 - reach;  // [s]
    CHECK_FALSE(meets(0, touch - 1e-9));
    CHECK(meets(0, touch + 1e-9));
    CHECK(meets(2 * reach - 1e-9, 100));
    CHECK_FALSE(meets(2 * reach + 1e-9, 100));
  }
}

TEST_CASE("can_touch: where it says no, no impact is found, and where one is found, it says yes") {
  test::Random rng(1171);
  int touching = 0, apart = 0;
  for (int i = 0; i < 300; ++i) {
    ContactScene scene = scene_of({rod(Vec3(-2.5, 0, 0), 4 * rng.vector(), 5 * rng.vector()),
                                   rod(Vec3(2.5, 0, 0), 4 * rng.vector(), 5 * rng.vector())});
    scene.walls = {{Vec3(0, 0, -3), Vec3::UnitZ()}};
    const double until = rng.uniform(0, 1.2);
    const bool hit = !simulate_contacts(scene, {.until = until, .max_impacts = 1}).impacts.empty();
    const bool can = can_touch(scene, until);
    CHECK((can || !hit));
    touching += hit;
    apart += !can;
  }
  CHECK(touching > 50);
  CHECK(apart > 50);
}

TEST_CASE("can_touch: nothing at all touches nothing, and a time that is none is refused") {
  CHECK_FALSE(can_touch(scene_of({}), 1));
  CHECK_FALSE(can_touch(scene_of({rod(Vec3::Zero(), Vec3::Zero())}), 1));
  CHECK_REFUSED(can_touch(scene_of({}), -1), "until");
  CHECK_REFUSED(can_touch(scene_of({}), INFINITY), "until");
}
