/// @file
/// Particles move as closed forms and conservation laws say.

#include <doctest/doctest.h>

#include <numbers>

#include "project/harness/inputs.hpp"
#include "tumble/ode.hpp"
#include "tumble/particles.hpp"

using namespace tumble;

namespace {

using Pair = std::array<particles::Particle<>, 2>;

Vec3 momentum(const Pair& particles) {
  return particles[0].mass * particles[0].v + particles[1].mass * particles[1].v;
}

double energy(const Pair& particles, const particles::Spring& spring) {
  const double stretch = (particles[0].x - particles[1].x).norm() - spring.rest_length;
  return particles[0].mass * particles[0].v.squaredNorm() / 2 +
         particles[1].mass * particles[1].v.squaredNorm() / 2 +
         spring.stiffness * stretch * stretch / 2;
}

const Pair dumbbell{particles::Particle<>{1, {0, 0, 0}, {0, 1, 0.5}},
                    particles::Particle<>{2, {1.5, 0, 0}, {0.3, 0, 0}}};

}  // namespace

TEST_CASE("motion: a projectile flies on a parabola, which RK4 takes in one step") {
  const std::array<particles::Particle<>, 1> ball{
      particles::Particle<>{0.3, {1, 2, 3}, {10, 0, 20}}};
  const particles::ParticleSystem system(ball, particles::UniformGravity{{0, 0, -9.81}});
  const auto [end] =
      particles::unflatten(runge_kutta::rk4_step(system, 0, particles::flatten(ball), 2.0), ball);
  const Vec3 expected = Vec3(1, 2, 3) + 2 * Vec3(10, 0, 20) + 2 * Vec3(0, 0, -9.81);
  CHECK((end.x - expected).norm() <= 12 * test::eps * 45);
  CHECK((end.v - Vec3(10, 0, 20 - 2 * 9.81)).norm() <= 12 * test::eps * 45);
}

TEST_CASE("motion: drag lets a fall approach its terminal velocity") {
  const double m = 0.5, g = 9.81, k = 0.2, t = 3;
  const std::array<particles::Particle<>, 1> drop{particles::Particle<>{m, {0, 0, 0}, {0, 0, 0}}};
  const particles::UniformGravity gravity{{0, 0, -g}};
  const Tolerances tight{1e-10, 1e-10};
  const auto speed = [&](const auto& drag, double until) {
    const particles::ParticleSystem system(drop, gravity, drag);
    return -integrate_adaptive<Dop853>(system, particles::flatten(drop), 0, until, tight).y[5];
  };
  // v = m g/k (1 − e^(−k t/m)), and with |v| v: √(m g/k) tanh(t √(g k/m)). Some ten steps.
  CHECK(std::abs(speed(particles::LinearDrag{k}, t) - m * g / k * (1 - std::exp(-k * t / m))) <=
        1e-8);
  CHECK(std::abs(speed(particles::QuadraticDrag{k}, t) -
                 std::sqrt(m * g / k) * std::tanh(t * std::sqrt(g * k / m))) <= 1e-8);
  CHECK(std::abs(speed(particles::LinearDrag{k}, 100) - m * g / k) <= 1e-8);
  CHECK(std::abs(speed(particles::QuadraticDrag{k}, 100) - std::sqrt(m * g / k)) <= 1e-8);
}

TEST_CASE("motion: two masses on a spring swing with ω² = k (1/m₁ + 1/m₂), damped or not") {
  const double k = 6, m1 = 1, m2 = 2, rest = 1, stretch = 0.25;
  const double reduced = m1 * m2 / (m1 + m2), t = 2;
  for (const double d : {0.0, 0.4}) {
    CAPTURE(d);
    const Pair pair{particles::Particle<>{m1, {0, 0, 0}, {0, 0, 0}},
                    particles::Particle<>{m2, {rest + stretch, 0, 0}, {0, 0, 0}}};
    const particles::ParticleSystem system(pair, particles::Spring{0, 1, k, d, rest});
    const auto y =
        integrate_adaptive<Dop853>(system, particles::flatten(pair), 0, t, {1e-11, 1e-11}).y;
    const double decay = d / (2 * reduced), omega = std::sqrt(k / reduced - decay * decay);
    const double expected = stretch * std::exp(-decay * t) *
                            (std::cos(omega * t) + decay / omega * std::sin(omega * t));
    // Some twenty steps with an error of at most 1e-11 of numbers near 1.
    CHECK(std::abs(y[6] - y[0] - rest - expected) <= 1e-9);
  }
}

TEST_CASE("motion: a damped spring keeps the momentum, whatever the method") {
  const particles::ParticleSystem system(dumbbell, particles::Spring{0, 1, 50, 3, 1});
  const Vec3 before = momentum(dumbbell);
  const auto check = [&](const auto& y) {
    // A linear invariant: every Runge–Kutta method keeps it to rounding, 1000 steps of it.
    CHECK((momentum(particles::unflatten(y, dumbbell)) - before).norm() <= 1000 * 8 * test::eps);
  };
  check(integrate_fixed<runge_kutta::Euler>(system, particles::flatten(dumbbell), 0, 1, 1000));
  check(integrate_fixed<Rk4>(system, particles::flatten(dumbbell), 0, 1, 1000));
  check(integrate_adaptive<DormandPrince54>(system, particles::flatten(dumbbell), 0, 10).y);
}

TEST_CASE("motion: without damping, the energy is kept to the order of the method") {
  const particles::Spring spring{0, 1, 50, 0, 1};
  const particles::ParticleSystem system(dumbbell, spring);
  const double before = energy(dumbbell, spring);
  std::vector<double> h, lost;
  for (const int steps : {200, 400, 800, 1600}) {
    const auto y = integrate_fixed<Rk4>(system, particles::flatten(dumbbell), 0, 5, steps);
    h.push_back(5.0 / steps);
    lost.push_back(std::abs(energy(particles::unflatten(y, dumbbell), spring) - before));
  }
  // RK4 damps an oscillator in its h⁶ term: the energy's order is 5 where the amplitude's is 4.
  CHECK(runge_kutta::observed_order(h, lost) >= 3.8);
  CHECK(runge_kutta::observed_order(h, lost) <= 5.2);
}
