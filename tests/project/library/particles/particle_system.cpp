#include "tumble/particles/particle_system.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <string>

#include "project/harness/inputs.hpp"
#include "tumble/ode.hpp"
#include "tumble/particles.hpp"

using namespace tumble;

namespace {

using List = std::vector<particles::Particle<>>;

template <class F>
std::string refusal_of(F&& f) {
  try {
    f();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A triangle that swings, so that nothing in it is special.
const List triangle{
    {1, {0, 0, 0}, {0.1, 0.2, 0}}, {2, {1, 0, 0}, {0, 0, 0.3}}, {3, {0, 1, 0.5}, {-0.1, 0, 0.1}}};

}  // namespace

TEST_CASE("particle system: a worked number") {
  const List particles{{2, {0, 0, 0}, {1, 0, 0}}, {4, {3, 0, 0}, {0, 1, 0}}};
  const particles::ParticleSystem system(particles, particles::UniformGravity{{0, 0, -10}},
                                         particles::LinearDrag{2},
                                         particles::Spring{0, 1, 8, 0, 1});
  Eigen::VectorXd expected(12);
  // The spring is 2 m too long: 16 N on each end. Drag: 2 N against each velocity.
  expected << 1, 0, 0, (16.0 - 2) / 2, 0, -10, 0, 1, 0, -16.0 / 4, -2.0 / 4, -10;
  CHECK(system.dydt(0, particles::flatten(particles)) == expected);
  CHECK(system(0, particles::flatten(particles)) == expected);
}

TEST_CASE("particle system: the user's own forces, of both shapes, and none at all") {
  const List particles{{2, {1, 2, 3}, {4, 5, 6}}, {4, {0, 0, 0}, {0, 0, 0}}};
  const auto wind = [](double t, const particles::Particle<>&) { return Vec3(t, 0, 0); };
  const auto rope = [](double, const auto& all, const auto& push) {
    push(1, Vec3(all.x(0) * all.mass(1)));
  };
  const Eigen::VectorXd a =
      particles::ParticleSystem(particles, wind, rope).dydt(3, particles::flatten(particles));
  CHECK(a.segment<3>(3) == Vec3(1.5, 0, 0));
  CHECK(a.segment<3>(9) == Vec3(1.75, 2, 3));
  const Eigen::VectorXd free =
      particles::ParticleSystem(particles).dydt(3, particles::flatten(particles));
  CHECK(free.segment<3>(0) == Vec3(4, 5, 6));
  CHECK(free.segment<3>(3) == Vec3::Zero());
}

TEST_CASE("particle system: fixed and dynamic, float, and the C interface say the same") {
  const auto forces = [](const auto& particles) {
    return particles::ParticleSystem(particles, particles::UniformGravity{{0, 1, -9.81}},
                                     particles::LinearDrag{0.1}, particles::QuadraticDrag{0.2},
                                     particles::Spring{0, 2, 30, 0.5, 1});
  };
  const std::array<particles::Particle<>, 3> fixed{triangle[0], triangle[1], triangle[2]};
  std::array<particles::Particle<float>, 3> in_float;
  for (std::size_t i = 0; i < 3; ++i)
    in_float[i] = {static_cast<float>(fixed[i].mass), fixed[i].x.cast<float>(),
                   fixed[i].v.cast<float>()};
  const Eigen::VectorXd expected = forces(triangle).dydt(0, particles::flatten(triangle));
  CHECK(forces(fixed).dydt(0, particles::flatten(fixed)) == expected);
  // A dozen roundings in float of forces up to 30.
  CHECK((forces(in_float).dydt(0, particles::flatten(in_float)).cast<double>() - expected).norm() <=
        12 * 30 * 0x1p-24);

  const Eigen::VectorXd y0 = particles::flatten(triangle);
  const std::vector<double> start(y0.data(), y0.data() + y0.size());
  const std::vector<double> end = ode(start, 0, 2, forces(triangle));
  const auto typed = integrate_adaptive<DormandPrince54>(forces(triangle), y0, 0, 2);
  CHECK(Eigen::Map<const Eigen::VectorXd>(end.data(), 18) == typed.y);
}

TEST_CASE("particle system: refuses masses, forces and states that make no sense") {
  const auto with = [](const auto& force) {
    return refusal_of([&] { particles::ParticleSystem(triangle, force); });
  };
  CHECK(with(particles::Spring{0, 2, 1, 1, 1}) == "");
  CHECK(contains(with(particles::Spring{0, 3, 1, 1, 1}), "no particle 3 among 3"));
  CHECK(contains(with(particles::Spring{-1, 2, 1, 1, 1}), "no particle -1 among 3"));
  CHECK(contains(with(particles::Spring{1, 1, 1, 1, 1}), "both ends are particle 1"));
  CHECK(contains(with(particles::Spring{0, 1, -5, 1, 1}), "stiffness = -5"));
  CHECK(contains(with(particles::Spring{0, 1, 1, std::nan(""), 1}), "damping = nan"));
  CHECK(contains(with(particles::Spring{0, 1, 1, 1, -1}), "rest_length = -1"));
  CHECK(contains(with(particles::LinearDrag{-1}), "linear drag: k = -1"));
  CHECK(contains(with(particles::QuadraticDrag{INFINITY}), "quadratic drag: k = inf"));
  CHECK(contains(with(particles::UniformGravity{{0, std::nan(""), 0}}), "g = (  0 nan   0)"));
  for (const double mass : {0.0, -1.0, std::nan(""), static_cast<double>(INFINITY)}) {
    CAPTURE(mass);
    List particles = triangle;
    particles[1].mass = mass;
    CHECK(
        contains(refusal_of([&] { particles::ParticleSystem{particles}; }), "particle 1: mass = "));
  }
  CHECK(contains(
      refusal_of([&] { particles::ParticleSystem(triangle).dydt(0, Eigen::VectorXd::Zero(17)); }),
      "a state of 17 numbers for 3 particles"));
}
