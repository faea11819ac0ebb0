/// @file
/// 9.2 unpack: its laws, and what goes wrong.
#include "09_rigid_body/contract.hpp"
#include "judge/spec/shared/bodies.hpp"
#include "judge/spec/shared/rigid_body_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace bodies;

namespace student {
const Function<decltype(rigid_body::unpack)> unpack{TUMBLE_UNIT};
}

namespace {

/// y as the numbers from these places on are taken for x, q, P and L.
auto from_places(int x, int q, int P, int L) {
  return [=](const PackedState& y) -> State {
    State state;
    state.x = y.segment<3>(x), state.q = y.segment<4>(q);
    state.P = y.segment<3>(P), state.L = y.segment<3>(L);
    return state;
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any thirteen numbers: x, then q, then P, then L, unrounded") {
    for (int n = 0; n < 20; ++n) {
      const State state = any_state();
      REQUIRE(student::unpack(reference::pack(state)) == close_to(state, 0));
    }
  }

  TEST_CASE("what is packed comes back, and what comes back packs to the same numbers") {
    for (int n = 0; n < 10; ++n) {
      const PackedState y = reference::pack(any_state());
      const auto state = student::unpack(y);
      REQUIRE(state == close_to(reference::unpack(y), 0));
      REQUIRE(state == obeys("pack(unpack(y)) = y", (reference::pack(state) - y).norm(), 0));
    }
  }

  TEST_CASE("each of the thirteen numbers goes to its own place, the right one") {
    for (int place = 0; place < 13; ++place) {
      const PackedState y = PackedState::Unit(place);
      REQUIRE(student::unpack(y) == close_to(reference::unpack(y), 0));
    }
  }

  TEST_CASE("a state whose q has drifted from length 1 comes out as it is, and so with −q") {
    for (const double drift : {1e-15, 1e-9, 1e-3, 0.1, 1.}) {
      State state = any_state();
      state.q = (1 + drift) * any_unit_quaternion();
      REQUIRE(student::unpack(reference::pack(state)) == close_to(state, 0));
      state.q = -state.q;
      REQUIRE(student::unpack(reference::pack(state)) == close_to(state, 0));
    }
  }

  TEST_CASE("thirteen zeros, tiny numbers and huge ones") {
    for (const double size : {0., 1e-300, 1e-8, 1e8, 1e300}) {
      const State state = any_state(size);
      REQUIRE(student::unpack(reference::pack(state)) == close_to(state, 0));
    }
  }
}

const Misconceptions<decltype(rigid_body::unpack)> misconceptions{
    TUMBLE_UNIT,
    {{"scalar read last",
      "You read the quaternion as (x, y, z, w). In y its numbers are in the order of the "
      "quaternion itself, the scalar first.",
      "Packing",
      [](const PackedState& y) {
        State s = reference::unpack(y);
        s.q = Quaternion(s.q[3], s.q[0], s.q[1], s.q[2]);
        return s;
      }},
     {"momentum before the orientation",
      "You took the numbers behind x for P, and read q behind them. In y the orientation follows "
      "the position, and the two momenta come last.",
      "Packing", from_places(0, 6, 3, 10)},
     {"momenta swapped",
      "You swapped P and L. The linear momentum comes first, as the position comes before the "
      "orientation.",
      "Packing", from_places(0, 3, 10, 7)},
     {"orientation first", "You read q from the front, where x is. The position comes first.",
      "Packing", from_places(4, 0, 7, 10)},
     {"three places for the quaternion",
      "You read P and L one place too early, so P begins with the last number of q. A quaternion "
      "has four numbers.",
      "Packing", from_places(0, 3, 6, 9)},
     {"places counted from one",
      "You read x from the second number on, and everything else one place too late. In C++ the "
      "first number of a vector is at place 0.",
      "Packing",
      [](const PackedState& y) {
        PackedState shifted = PackedState::Zero();
        shifted.head<12>() = y.tail<12>();
        return reference::unpack(shifted);
      }},
     {"normalised",
      "You scaled the quaternion to length 1. That changes the solver's state behind its back, in "
      "the middle of a step.",
      "Packing",
      [](const PackedState& y) {
        State s = reference::unpack(y);
        if (!s.q.isZero(0)) s.q.stableNormalize();
        return s;
      }},
     {"sign of the quaternion changed",
      "Where w is negative, you changed the signs of all four numbers of q. That is the same "
      "rotation, but not the same state of the solver.",
      "Packing", [](const PackedState& y) {
        State s = reference::unpack(y);
        if (s.q[0] < 0) s.q = -s.q;
        return s;
      }}}};
