/// @file
/// Each force by itself: UniformGravity, LinearDrag, QuadraticDrag, Spring.

#include <doctest/doctest.h>

#include <array>

#include "project/harness/inputs.hpp"
#include "tumble/particles.hpp"

using namespace tumble;
using test::Random;

static_assert(particles::ParticleForce<particles::UniformGravity, float> &&
              particles::ParticleForce<particles::QuadraticDrag, double>);
static_assert(particles::SystemForce<particles::Spring, double> &&
              !particles::ParticleForce<particles::Spring, double>);
static_assert(!particles::Force<double, double> && !particles::Force<std::string, double>);

namespace {

/// The forces of the spring on its two ends.
std::array<Vec3, 2> forces_of(const particles::Spring& spring,
                              const std::array<particles::Particle<>, 2>& ends) {
  const auto y = particles::flatten(ends);
  const std::array<double, 2> masses{ends[0].mass, ends[1].mass};
  std::array<double, 12> sums{};
  spring(0.0, particles::ParticlesView<double>(y.data(), masses.data(), 2),
         particles::ForceSums<double>(sums.data()));
  return {Vec3(sums[3], sums[4], sums[5]), Vec3(sums[9], sums[10], sums[11])};
}

}  // namespace

TEST_CASE("gravity and drag: worked numbers") {
  const particles::Particle<> particle{2, {1, 1, 1}, {3, 0, -4}};
  CHECK(particles::UniformGravity{{0, 0, -10}}(0.0, particle) == Vec3(0, 0, -20));
  CHECK(particles::LinearDrag{0.5}(0.0, particle) == Vec3(-1.5, 0, 2));
  CHECK(particles::QuadraticDrag{0.5}(0.0, particle) == Vec3(-7.5, 0, 10));
}

TEST_CASE("spring: a worked number") {
  // 5 long instead of 2, growing by 1 a second: 10·3 + 4·1 pull the ends together.
  const particles::Particle<> a{1, {0, 0, 0}, {0, 0, 0}}, b{1, {3, 4, 0}, {0.6, 0.8, 7}};
  const std::array<Vec3, 2> F = forces_of({0, 1, 10, 4, 2}, {a, b});
  CHECK((F[0] - 34 * Vec3(0.6, 0.8, 0)).norm() <= 34 * 8 * test::eps);
  CHECK(F[1] == -F[0]);
}

TEST_CASE("spring: action is reaction, along the line between its ends") {
  Random rng(101);
  for (int i = 0; i < 200; ++i) {
    const particles::Particle<> a{1, rng.vector(), rng.vector()}, b{1, rng.vector(), rng.vector()};
    const particles::Spring spring{0, 1, rng.uniform(0, 9), rng.uniform(0, 9), rng.uniform(0, 3)};
    CAPTURE(a.x.transpose());
    CAPTURE(b.x.transpose());
    const std::array<Vec3, 2> F = forces_of(spring, {a, b});
    CHECK(F[0] == -F[1]);
    CHECK(F[0].cross(a.x - b.x).norm() <= 8 * test::eps * F[0].norm() * (a.x - b.x).norm());
    // The other end first is the same spring.
    particles::Spring turned = spring;
    std::swap(turned.i, turned.j);
    CHECK((forces_of(turned, {a, b})[0] - F[0]).norm() <= 8 * test::eps * F[0].norm());
  }
}

TEST_CASE("spring: slack at its rest length, and without force where it has no direction") {
  const particles::Particle<> a{1, {1, 2, 3}, {0, 0, 0}}, b{1, {1, 2, 5}, {0, 0, 0}};
  CHECK(forces_of({0, 1, 10, 4, 2}, {a, b})[0] == Vec3::Zero());
  const particles::Particle<> moving{1, a.x, {1, 1, 1}};
  CHECK(forces_of({0, 1, 10, 4, 2}, {a, moving})[0] == Vec3::Zero());
  CHECK(forces_of({0, 1, 10, 4, 2}, {a, moving})[1] == Vec3::Zero());
}

TEST_CASE("drag: takes energy from every motion") {
  Random rng(102);
  for (int i = 0; i < 200; ++i) {
    const particles::Particle<> particle{1, rng.vector(), rng.vector()};
    CAPTURE(particle.v.transpose());
    CHECK(particles::LinearDrag{0.1}(0.0, particle).dot(particle.v) < 0);
    CHECK(particles::QuadraticDrag{0.1}(0.0, particle).dot(particle.v) < 0);
  }
}
