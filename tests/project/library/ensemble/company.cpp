/// @file
/// What happens to a body does not depend on the others, to the last bit.
///
/// Compiled as users do, with products and sums that the compiler may make one instruction of:
/// where it does must be the same for every body. The namespace gets another name here, so that no
/// other file of this program, which all are compiled without, shares a function with this one.
#define tumble tumble_fused
#undef TUMBLE_COMPILED

#include <doctest/doctest.h>

#include <algorithm>

#include "scenes.hpp"

using namespace tumble;

namespace {

constexpr int steps = 30;
const ForceAtBodyPoint pull{Vec3(0.4, -0.3, -2), Vec3(0.2, 0.5, -0.3)};

template <class Method, class... Forces>
struct Scene {
  std::tuple<Forces...> forces;

  Ensemble after(Ensemble ensemble, const simd::LoopOptions& loop) const {
    const auto go = [&](const Forces&... force) {
      return advance<Method>(ensemble, {0.01, steps, 0, loop}, force...);
    };
    CHECK(std::apply(go, forces).count == 0);
    return ensemble;
  }
};

template <class Method, class... Forces>
Scene<Method, Forces...> scene(const Forces&... forces) {
  return {{forces...}};
}

/// Every number of bodies up to three Packs' worth, each body against itself alone.
void check_alone(const auto& scene, const simd::LoopOptions& loop) {
  const test::Bodies all = test::random_bodies(19, 3, 611);
  std::vector<RigidBodyState<>> alone;
  for (std::size_t i = 0; i < all.size(); ++i)
    alone.push_back(scene.after(all.alone(i), loop).state(0));
  for (std::size_t n = 1; n <= all.size(); ++n) {
    const Ensemble together = scene.after({{all.bodies.data(), n}, {all.states.data(), n}}, loop);
    for (std::size_t i = 0; i < n; ++i) CHECK(test::same(together.state(i), alone[i]));
  }
}

/// Enough bodies for several chunks, and to be worth three threads: turned about and by several.
void check_places_and_threads(const auto& scene, simd::InstructionSet set) {
  test::Bodies all = test::random_bodies(1200, 3, 612);
  const Ensemble one = scene.after(all.ensemble(), {1, set});
  for (const int threads : {2, 3}) {
    const Ensemble several = scene.after(all.ensemble(), {threads, set});
    for (std::size_t i = 0; i < all.size(); ++i) CHECK(test::same(several.state(i), one.state(i)));
  }
  std::reverse(all.bodies.begin(), all.bodies.end());
  std::reverse(all.states.begin(), all.states.end());
  const Ensemble reversed = scene.after(all.ensemble(), {2, set});
  for (std::size_t i = 0; i < all.size(); ++i)
    CHECK(test::same(reversed.state(all.size() - 1 - i), one.state(i)));
}

void check(const std::string& name, const auto& scene) {
  CAPTURE(name);
  for (const simd::InstructionSet set : test::instruction_sets()) {
    CAPTURE(static_cast<int>(set));
    check_alone(scene, {1, set});
    check_places_and_threads(scene, set);
  }
}

}  // namespace

TEST_CASE("company: a body moves as if alone, in any place, with any number of threads") {
  check("free, default", scene<void>());
  check("free, Rk4", scene<Rk4>());
  check("free, order 6", scene<TaylorMagnus<6>>());
  check("free, order 8", scene<TaylorMagnus<8>>());
  check("pushed, default", scene<void>(Weight{}, pull, BodyDrag{0.4, 0.3}));
  check("pushed, Rk4", scene<Rk4>(Weight{}, pull, BodyDrag{0.4, 0.3}));
  check("dragged hard", scene<void>(BodyDrag{4, 0.3}));  // for some |κ T| > ½, for others not
  check("pushed, order 8", scene<TaylorMagnus<8>>(pull, BodyDrag{0.4, 0.3}));
  check("tethered", scene<Rk4>(Weight{}, test::Tether{}));
}

TEST_CASE("company: a body that is lost is named, and takes no other with it") {
  const test::Bodies all = test::random_bodies(300, 3, 613);
  std::vector<ForceAtBodyPoint> pulls(all.size(), pull);
  for (const std::size_t i : {291u, 6u, 12u}) pulls[i].force = Vec3(1e300, 0, 0);
  for (const simd::InstructionSet set : test::instruction_sets()) {
    Ensemble ensemble = all.ensemble();
    const LostBodies lost = advance(ensemble, {0.1, steps, 0, {2, set}}, ensemble::PerBody{pulls});
    CHECK(lost.count == 3);
    CHECK(lost.first == 6);
    for (std::size_t i = 0; i < all.size(); ++i) {
      CHECK(pack(ensemble.state(i)).allFinite() == (pulls[i].force == pull.force));
      if (pulls[i].force != pull.force) continue;
      Ensemble alone = all.alone(i);
      CHECK(advance(alone, {0.1, steps, 0, {1, set}}, pull).count == 0);
      CHECK(test::same(ensemble.state(i), alone.state(0)));
    }
    CHECK(advance(ensemble, {0.1, 0}).first == 6);  // it stays lost, and is named again
  }
}

TEST_CASE("company: a user's force that is not defined everywhere, nor in lanes without a body") {
  const test::Bodies all = test::random_bodies(7, 1, 614);
  const auto spoil =
      []<class P>(double, const ensemble::PackBody<P>& body, const ensemble::PackKinematics<P>& now)
          __attribute__((always_inline)) {
    P zero{};  // for body 3 and behind the last
    for (int i = 0; i < simd::lanes<P>; ++i) {
      const std::size_t number = body.first + static_cast<std::size_t>(i);
      zero[i] = number == 3 || number >= 7 ? 0 : 1;
    }
    return ensemble::PackWrench<P>{P(-1 / zero) * now.x, {}};
  };
  Ensemble ensemble = all.ensemble();
  const LostBodies lost = advance(ensemble, {0.01, 10}, spoil);
  CHECK(lost.count == 1);
  CHECK(lost.first == 3);
  for (std::size_t i = 0; i < 7; ++i) CHECK(pack(ensemble.state(i)).allFinite() == (i != 3));
}
