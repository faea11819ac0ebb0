/// @file
/// The ensemble's methods against the equation of motion, integrated to the last digits.

#include <doctest/doctest.h>

#include "reference/rigid_body.hpp"
#include "scenes.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/observed_order.hpp"

using namespace tumble;
using test::eps;

namespace {

constexpr double duration = 1;
constexpr int bodies = 11;
const ForceAtBodyPoint pull{Vec3(0.4, -0.3, -2), Vec3(0.2, 0.5, -0.3)};
const ForceAtBodyPoint push{Vec3(0, 1, 0.5), Vec3(-0.4, 0.1, 0.2)};
const BodyDrag drag{0.4, 0.3};

/// Where each body is after the duration, alone and one after the other.
template <class... Forces>
std::vector<RigidBodyState<>> truth(const test::Bodies& all, const Forces&... forces) {
  std::vector<RigidBodyState<>> ends;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RigidBodyRhs motion(all.bodies[i], forces...);
    ends.push_back(unpack<double>(
        integrate_adaptive<Dop853>(motion, pack(all.states[i]), 0.0, duration, {1e-14, 1e-14}).y));
  }
  return ends;
}

/// The largest error of an orientation and of the other numbers.
struct Errors {
  double angle = 0, L = 0, path = 0;
};

Errors errors(const Ensemble& ensemble, const std::vector<RigidBodyState<>>& ends) {
  Errors worst;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const RigidBodyState<> end = ensemble.state(i);
    worst.angle = std::max(worst.angle, angle_between(end.q, ends[i].q));
    worst.L = std::max(worst.L, (end.L - ends[i].L).norm());
    worst.path = std::max({worst.path, (end.x - ends[i].x).norm(), (end.P - ends[i].P).norm()});
  }
  return worst;
}

template <class Method, class... Forces>
Errors errors_after(int steps, const test::Bodies& all, const std::vector<RigidBodyState<>>& ends,
                    const Forces&... forces) {
  Ensemble ensemble = all.ensemble();
  CHECK(advance<Method>(ensemble, {duration / steps, steps}, forces...).count == 0);
  return errors(ensemble, ends);
}

/// @param fewest steps at which h^order is seen; 2.4 times as many are still far from rounding
template <class Method, class... Forces>
void check_order(const std::string& name, int fewest, const Forces&... forces) {
  const test::Bodies all = test::random_bodies(bodies, 2, 601);
  const auto ends = truth(all, forces...);
  std::vector<double> h, angles, momenta;
  for (int steps = fewest; h.size() < 4; steps += steps / 3) {
    const Errors e = errors_after<Method>(steps, all, ends, forces...);
    h.push_back(duration / steps);
    angles.push_back(e.angle);
    momenta.push_back(e.L);
  }
  const double of_angle = runge_kutta::observed_order(h, angles),
               of_L = runge_kutta::observed_order(h, momenta);
  MESSAGE(name << ": order " << Method::order << ", seen " << of_angle << " in the angle, " << of_L
               << " in L; errors " << angles.back() << ", " << momenta.back());
  // The terms of the next orders bend the line a little.
  CHECK(std::abs(of_angle - Method::order) <= 0.35);
  CHECK(std::abs(of_L - Method::order) <= 0.35);
}

template <class... Forces>
void check_orders(const std::string& name, const Forces&... forces) {
  CAPTURE(name);
  check_order<Rk4>("Rk4", 40, forces...);
  check_order<TaylorMagnus<4>>("TaylorMagnus<4>", 40, forces...);
  check_order<TaylorMagnus<6>>("TaylorMagnus<6>", 20, forces...);
  check_order<TaylorMagnus<8>>("TaylorMagnus<8>", 8, forces...);
}

}  // namespace

TEST_CASE("advance: every method has its order, whatever pushes") {
  check_orders("nothing");
  check_orders("a force at a point", pull);
  check_orders("drag", drag);
  check_orders("all of them", Weight{}, pull, drag, push);
}

TEST_CASE("advance: a force of one's own, on everything it may depend on, at order 4") {
  check_order<Rk4>("Rk4", 40, test::Tether{});
  check_order<Rk4>("Rk4", 40, Weight{}, pull, test::Tether{}, drag);
}

TEST_CASE("advance: Rk4 errs as integrate_fixed<Rk4> on the library's equation of motion does") {
  const test::Bodies all = test::random_bodies(bodies, 2, 602);
  const auto ends = truth(all, pull, drag);
  constexpr int steps = 60;
  std::vector<RigidBodyState<>> fixed;
  for (std::size_t i = 0; i < all.size(); ++i)
    fixed.push_back(unpack<double>(integrate_fixed<Rk4>(
        RigidBodyRhs(all.bodies[i], pull, drag), pack(all.states[i]), 0.0, duration, steps)));
  double peer = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    peer = std::max(peer, angle_between(fixed[i].q, ends[i].q));
  const double own = errors_after<Rk4>(steps, all, ends, pull, drag).angle;
  MESSAGE("angle after " << steps << " steps: " << own << ", integrate_fixed " << peer);
  CHECK(own <= 2 * peer);  // not the same numbers: ω is integrated here, L there
}

TEST_CASE("advance: centres of mass are where the laws of motion put them, with any step") {
  const test::Bodies all = test::random_bodies(bodies, 2, 603);
  const auto ends = truth(all, Weight{}, pull, drag);
  const double allowed = 64 * eps * 10 + 1e-13;  // of the integration that is the truth here
  CHECK(errors_after<Rk4>(1, all, ends, Weight{}, pull, drag).path <= allowed);
  CHECK(errors_after<TaylorMagnus<4>>(7, all, ends, Weight{}, pull, drag).path <= allowed);
}

TEST_CASE("advance: forces may differ from body to body") {
  const test::Bodies all = test::random_bodies(bodies, 2, 604);
  test::Random rng(605);
  std::vector<ForceAtBodyPoint> pulls;
  std::vector<BodyDrag> drags;
  std::vector<RigidBodyState<>> ends;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec3 F = rng.vector();
    pulls.push_back({F, rng.vector()});
    const double k = rng.uniform(0, 1);
    drags.push_back({k, rng.uniform(0, 1)});
    ends.push_back(truth({{all.bodies[i]}, {all.states[i]}}, pulls[i], drags[i])[0]);
  }
  const Errors e = errors_after<TaylorMagnus<8>>(40, all, ends, ensemble::PerBody{pulls},
                                                 ensemble::PerBody{drags}, Weight{{0, 0, 0}});
  CHECK(e.angle <= 1e-12);  // (0.05)⁹ · 40 and the truth's own error
  CHECK(e.L <= 1e-12);
  CHECK(e.path <= 1e-12);
}

TEST_CASE("advance: back in time leads back") {
  const test::Bodies all = test::random_bodies(bodies, 2, 606);
  Ensemble ensemble = all.ensemble();
  constexpr int steps = 50;
  CHECK(advance<TaylorMagnus<8>>(ensemble, {0.01, steps}, pull, drag).count == 0);
  CHECK(advance<TaylorMagnus<8>>(ensemble, {-0.01, steps}, pull, drag).count == 0);
  const Errors e = errors(ensemble, all.states);
  // Rounding alone: 2 · 50 steps, some of each in q, ω, x and v.
  CHECK(e.angle <= 100 * 8 * eps);
  CHECK(e.L <= 100 * 8 * eps * 10);
  CHECK(e.path <= 100 * eps);
}

TEST_CASE("advance: a user's force is told the time") {
  const test::Bodies all = test::random_bodies(3, 1, 607);
  const auto forces_at = [](double t0, const test::Bodies& some) {
    Ensemble ensemble = some.ensemble();
    CHECK(advance(ensemble, {0.01, 20, t0}, test::Tether{}).count == 0);
    return ensemble.state(1);
  };
  Ensemble twice = all.ensemble();
  CHECK(advance(twice, {0.01, 10, 0.5}, test::Tether{}).count == 0);
  CHECK(advance(twice, {0.01, 10, 0.6}, test::Tether{}).count == 0);
  CHECK((pack(twice.state(1)) - pack(forces_at(0.5, all))).norm() <= 20 * 32 * eps);
  CHECK((pack(twice.state(1)) - pack(forces_at(0, all))).norm() > 1e-3);
}

TEST_CASE("advance: Rk4 begins every step with a q of length 1") {
  const test::Bodies all = test::random_bodies(4, 3, 608);
  constexpr double h = 0.1;
  double worst = 0;
  const auto look = [&]<class P>(double t, const ensemble::PackBody<P>&,
                                 const ensemble::PackKinematics<P>& now)
      __attribute__((always_inline)) {
    const P squares = now.q.w * now.q.w + now.q.x * now.q.x + now.q.y * now.q.y + now.q.z * now.q.z;
    if (std::abs(t / h - std::round(t / h)) < 0.25)
      for (int i = 0; i < 4; ++i) worst = std::max(worst, std::abs(squares[i] - 1));
    return ensemble::PackWrench<P>{};
  };
  Ensemble ensemble = all.ensemble();
  const simd::LoopOptions four_lanes{1, simd::InstructionSet::baseline};
  CHECK(advance(ensemble, {h, 100'000, 0, four_lanes}, look).count == 0);
  CHECK(worst > 0);
  // A step changes |q|² by less than 1e-4, and Newton's method leaves ⅜ of the square of that; 1e5
  // steps one after the other would leave 1e-5.
  CHECK(worst <= 3. / 8 * 1e-8);
}

TEST_CASE("advance: the flip of a body near its separatrix, known to 35 digits") {
  const RigidBody<> body(1, reference::free_body.I_body);
  const RigidBodyState<> start = reference::start(reference::free_body);
  Ensemble ensemble({&body, 1}, {&start, 1});
  constexpr int steps = 20000;
  CHECK(advance<TaylorMagnus<8>>(ensemble, {reference::free_body.duration / steps, steps}).count ==
        0);
  const RigidBodyState<> end = ensemble.state(0);
  // The condition number 2.7e6 stands before the first rounding, and each of 20,000 steps rounds:
  // as a random walk if they know nothing of each other.
  const double allowed = 2.7e6 * std::sqrt(steps) * 4 * eps;
  MESSAGE("angle " << angle_between(end.q, reference::free_body.q_end) << " of " << allowed);
  CHECK(angle_between(end.q, reference::free_body.q_end) <= allowed);
}

TEST_CASE("advance: the Lagrange top, known to 35 digits") {
  // Its weight acts on it as a force at the point e₃ does: only the centre would go away.
  const RigidBody<> body(1, reference::top.I_body);
  const RigidBodyState<> start = reference::start(reference::top);
  const ForceAtBodyPoint weight{Vec3(0, 0, -5), Vec3(0, 0, 1)};
  const auto angle = [&]<class Method>(Method, int steps) {
    Ensemble ensemble({&body, 1}, {&start, 1});
    CHECK(advance<Method>(ensemble, {reference::top.duration / steps, steps}, weight).count == 0);
    return angle_between(ensemble.state(0).q, reference::top.q_end);
  };
  const double coarse = angle(TaylorMagnus<8>{}, 2500), fine = angle(TaylorMagnus<8>{}, 5000);
  MESSAGE("Lagrange top, TaylorMagnus<8>: " << coarse << ", " << fine << "; Rk4 "
                                            << angle(Rk4{}, 5000));
  CHECK(fine <= coarse / 200 + 400 * std::sqrt(5000) * eps);  // 2⁸ less, or 400 rad of rounding
  CHECK(fine <= 1e-11);
  CHECK(angle(Rk4{}, 5000) <= 1e-4);
}
