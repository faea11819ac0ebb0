// What simulate() says of its error is true: hundreds of random scenes, all tolerances.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "project/harness/inputs.hpp"
#include "project/harness/sanitized.hpp"
#include "reference/double_double_motion.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/simulate/simulate.hpp"

using namespace tumble;

namespace {

/// A body of any size that starts anyhow.
struct Scene {
  double size;  ///< [kg], and everything else in proportion
  Vec3 J;
  RigidBodyState<> start;
  double t1;
  test::Random rng;

  RigidBody<> body() const { return RigidBody<>(size, Mat3(J.asDiagonal())); }
};

Scene random_scene(std::uint64_t seed) {
  test::Random rng(seed);
  const double size = std::pow(10, rng.uniform(-3, 3));
  const double a = rng.uniform(0.05, 1), b = rng.uniform(0.05, 1), c = rng.uniform(0, 1);
  const bool symmetric = seed % 5 == 0;
  const Vec3 J = size * (symmetric ? Vec3(b + c, b + c, 2 * b) : Vec3(b + c, a + c, a + b));
  const Vec3 omega = std::pow(10, rng.uniform(-1, 1.5)) * rng.vector();
  const Quat q = rng.rotation();
  const Vec3 L_body = J.cwiseProduct(omega), x = rng.vector(), v = rng.vector();
  const double t1 = rng.uniform(0.5, 10);
  return {size, J, {x, q, size * v, q * L_body}, t1, rng};
}

/// How often an error was how much larger than what was said.
struct Honesty {
  int kept = 0, tenfold = 0, unreached = 0, all = 0;

  void add(const SimulationReport& report, double error) {
    ++all;
    const double said = std::max(report.tolerance, report.error_estimate);
    INFO("asked ", report.tolerance, ", estimated ", report.error_estimate, ", true ", error);
    CHECK(error <= 100 * said);
    kept += error <= said;
    tenfold += error <= 10 * said;
    unreached += !report.reached();
  }
};

std::vector<double> all_tolerances() {
  return {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
}

/// The truth for any force: the method of order 8 in extended precision.
template <class... Forces>
RigidBodyState<long double> in_extended_precision(const Scene& scene, const Forces&... forces) {
  const RigidBody<long double> body(
      MassProperties{scene.size, Vec3::Zero(), Mat3(scene.J.asDiagonal())});
  const RigidBodyRhs<long double, Forces...> motion(body, forces...);
  const PackedState<long double> y = pack(scene.start).cast<long double>();
  return unpack<long double>(integrate_adaptive<Dop853>(motion, y, 0.0L,
                                                        static_cast<long double>(scene.t1),
                                                        {1e-17, 1e-17})
                                 .y);
}

template <class... Forces>
void check_against(const RigidBodyState<long double>& truth, const Scene& scene, double scale,
                   Honesty& honesty, const Forces&... forces) {
  for (const double tolerance : all_tolerances()) {
    const Trajectory found =
        simulate(scene.body(), scene.start, {0, scene.t1, tolerance}, forces...);
    const RigidBodyState<> end = found.end();
    const double angle = angle_between(end.q, Quat(truth.q.cast<double>().normalized()));
    const double off = (end.x - truth.x.cast<double>()).norm() / scale;
    honesty.add(found.report(), std::max(angle, off));
  }
}

}  // namespace

TEST_CASE("simulate: keeps the tolerance, or says what was reached: steady forces") {
  constexpr std::uint64_t scenes = test::tries(150, 3);
  Honesty honesty;
  for (std::uint64_t seed = 0; seed < scenes; ++seed) {
    CAPTURE(seed);
    Scene scene = random_scene(seed);
    const ForceAtBodyPoint f{10 * scene.size * scene.rng.vector(), scene.rng.vector()};
    const auto truth =
        reference::turned({scene.J, scene.start.q, scene.start.L, f.force, f.p_body}, scene.t1);
    for (const double tolerance : all_tolerances()) {
      const Trajectory found = simulate(scene.body(), scene.start, {0, scene.t1, tolerance}, f);
      honesty.add(found.report(), angle_between(found.end().q, truth.q));
    }
  }
  CHECK(honesty.kept >= 0.97 * honesty.all);
  CHECK(honesty.tenfold >= 0.99 * honesty.all);
  CHECK(honesty.unreached <= 0.02 * honesty.all);
}

TEST_CASE(
    "simulate: keeps the tolerance, or says what was reached: springs, drag, a push in time") {
  constexpr std::uint64_t scenes = test::tries(60, 3);
  Honesty honesty;
  for (std::uint64_t seed = 1000; seed < 1000 + scenes; ++seed) {
    CAPTURE(seed);
    Scene scene = random_scene(seed);
    test::Random& rng = scene.rng;
    const SpringToWorld spring{rng.vector(), 2 * rng.vector(), scene.size * rng.uniform(1, 50),
                               rng.uniform(0, 1)};
    const BodyDrag drag{scene.size * rng.uniform(0, 1), scene.size * rng.uniform(0, 0.1)};
    const Vec3 way = scene.size * rng.vector();
    const auto push = [way]<class T>(T t, const RigidBody<T>&, const Derived<T>&) -> Wrench<T> {
      using std::cos;
      return {way.cast<T>() * cos(3 * t), way.cast<T>() * cos(2 * t)};
    };
    const double scale = std::max(1.0, scene.t1);
    check_against(in_extended_precision(scene, Weight{}, spring, drag, push), scene, 10 * scale,
                  honesty, Weight{}, spring, drag, push);
  }
  CHECK(honesty.kept >= 0.97 * honesty.all);
  CHECK(honesty.tenfold >= 0.99 * honesty.all);
  CHECK(honesty.unreached <= 0.2 * honesty.all);
}
