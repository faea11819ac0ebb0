/// @file
/// 9.1 pack: its laws, and what goes wrong.
#include <utility>

#include "09_rigid_body/contract.hpp"
#include "judge/spec/shared/bodies.hpp"
#include "judge/spec/shared/rigid_body_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace bodies;

namespace student {
const Function<decltype(rigid_body::pack)> pack{TUMBLE_UNIT};
}

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any state: x first, then q, then P, then L, all numbers unrounded") {
    for (int n = 0; n < 20; ++n) {
      const State state = any_state();
      REQUIRE(student::pack(state) == close_to(reference::pack(state), 0));
    }
  }

  TEST_CASE("each of the thirteen numbers has its own place, the right one") {
    for (int place = 0; place < 13; ++place) {
      const PackedState y = PackedState::Unit(place);
      REQUIRE(student::pack(reference::unpack(y)) == close_to(y, 0));
    }
  }

  TEST_CASE("a state whose q has drifted from length 1 is packed as it is") {
    for (const double drift : {1e-15, 1e-9, 1e-3, 0.1, 1.}) {
      State state = any_state();
      state.q = (1 + drift) * any_unit_quaternion();
      REQUIRE(student::pack(state) == close_to(reference::pack(state), 0));
    }
  }

  TEST_CASE("a state with q, and the same with −q: both are packed as they are") {
    for (int n = 0; n < 5; ++n) {
      State state = any_state();
      REQUIRE(student::pack(state) == close_to(reference::pack(state), 0));
      state.q = -state.q;
      REQUIRE(student::pack(state) == close_to(reference::pack(state), 0));
    }
  }

  TEST_CASE("a body at rest in the origin, tiny numbers and huge ones") {
    const State at_rest{Vec3::Zero(), {1, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()};
    REQUIRE(student::pack(at_rest) == close_to(reference::pack(at_rest), 0));
    for (const double size : {1e-300, 1e-8, 1e8, 1e300}) {
      const State state = any_state(size);
      REQUIRE(student::pack(state) == close_to(reference::pack(state), 0));
    }
  }
}

const Misconceptions<decltype(rigid_body::pack)> misconceptions{
    TUMBLE_UNIT,
    {{"scalar stored last",
      "You packed the quaternion as (x, y, z, w). Here w comes first, as in the quaternion itself: "
      "q[0] is the scalar.",
      "Packing",
      [](State s) {
        s.q = Quaternion(s.q[1], s.q[2], s.q[3], s.q[0]);
        return reference::pack(s);
      }},
     {"momentum before the orientation",
      "You put P where q belongs, and q behind it. That is an order too, but not ours: first where "
      "the body is and how it is turned, then its two momenta.",
      "Packing",
      [](const State& s) -> PackedState {
        PackedState y;
        y << s.x, s.P, s.q, s.L;
        return y;
      }},
     {"momenta swapped",
      "You swapped P and L. The linear momentum comes first, as the position comes before the "
      "orientation.",
      "Packing",
      [](State s) {
        std::swap(s.P, s.L);
        return reference::pack(s);
      }},
     {"orientation first", "You put q before x. The position of the centre of mass comes first.",
      "Packing",
      [](const State& s) -> PackedState {
        PackedState y;
        y << s.q, s.x, s.P, s.L;
        return y;
      }},
     {"three places for the quaternion",
      "A quaternion has four numbers. You wrote P over its last one, so L follows one place too "
      "early and the last place stays empty.",
      "Packing",
      [](const State& s) -> PackedState {
        PackedState y = PackedState::Zero();
        y.segment<3>(0) = s.x;
        y.segment<4>(3) = s.q;
        y.segment<3>(6) = s.P;
        y.segment<3>(9) = s.L;
        return y;
      }},
     {"x left out",
      "You left the three places of the position at zero. q, P and L are where they belong, but a "
      "solver would put every body into the origin.",
      "Packing",
      [](State s) {
        s.x.setZero();
        return reference::pack(s);
      }},
     {"normalised",
      "You scaled the quaternion to length 1 on the way. Packing copies and repairs nothing: the "
      "solver needs the very q that it is trying out.",
      "Packing",
      [](State s) {
        if (!s.q.isZero(0)) s.q.stableNormalize();
        return reference::pack(s);
      }},
     {"sign of the quaternion changed",
      "Where w is negative, you packed −q instead of q. That is the same rotation, but not the "
      "same numbers: a solver that goes on from here sees a jump.",
      "Packing", [](State s) {
        if (s.q[0] < 0) s.q = -s.q;
        return reference::pack(s);
      }}}};
