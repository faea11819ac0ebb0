// Balls: all truths are closed forms, in long double.
#include <cmath>

#include "project/bench/contact/bodies.hpp"
#include "project/bench/contact/problem.hpp"

namespace tumble::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double radius = 0.1;
const long double g = -weight.z();

Scene dropped(double height, double e) {
  return {{ball(radius, 0.5, {0, 0, radius + height})}, {plane(Vec3::UnitZ())}, weight, e, 0, true};
}

// ── e = 1: it always comes back ──

Problem for_ever() {
  constexpr double height = 5, duration = 20;
  const Scene scene = dropped(height, 1);
  const long double half = std::sqrt(2 * height / g);  // from the top to the floor
  // The time since it was last on top.
  const long double s = std::remainder(static_cast<long double>(duration), 2 * half);
  const long double truth = radius + height - g * s * s / 2;
  const auto error = [truth](const std::vector<Motion>& end) {
    return static_cast<double>(std::abs(end[0].x.z() - truth));
  };
  // Each of ten contacts may be off by what places have digits for, and with it all later flights.
  constexpr double contacts = 10, digits = 16 * eps * (radius + height + radius);
  return {"ball",   "BALL: dropped from 5 m, e = 1, 20 s", "error of its height [m]", scene,
          duration, at_end(scene, duration, error),        2 * contacts * digits};
}

// ── e = 0.8: ever lower ──

constexpr double lossy = 0.8, from = 1;

/// The time of contact k = 1, 2, …: t₀ (1 + 2e + 2e² + … + 2eᵏ⁻¹).
long double time_of_contact(int k) {
  const long double first = std::sqrt(2 * from / g);
  long double t = first, flight = 2 * first;
  for (int i = 1; i < k; ++i) t += flight *= lossy;
  return t;
}

/// When a ball that leaves the floor was there, from where it is a little later.
double left_floor(const Motion& now, double t) {
  const double up = now.x.z() - radius, v = now.v.z();
  return t - 2 * up / (v + std::sqrt(std::fmax(0, v * v + 2 * up * -weight.z())));
}

double time_of_contact(Simulation& simulation, double h, int steps, int contact) {
  double before = 0;
  for (int i = 1; i <= steps; ++i) {
    simulation.advance(1);
    const Motion now = simulation.motion(0);
    if (before < 0 && now.v.z() > 0 && --contact == 0) return left_floor(now, i * h);
    before = now.v.z();
  }
  return infinity;
}

Problem bounces() {
  constexpr int k = 10;
  const long double truth = time_of_contact(k);
  const auto off = [truth](double t) { return static_cast<double>(std::abs(t - truth)); };
  const Question question{[off](Simulation& simulation, double h, int steps) {
                            return off(time_of_contact(simulation, h, steps, k));
                          },
                          [off](const contact::ContactScene&, const contact::ContactRun& run) {
                            return run.impacts.size() < k ? infinity : off(run.impacts[k - 1].t);
                          }};
  const double duration = static_cast<double>(truth + time_of_contact(k + 1)) / 2;
  // Ten contacts, each found to what places have digits for, at the slowest by 0.6 m/s.
  constexpr double promised = k * 16 * eps * (from + 2 * radius) / 0.6;
  return {"bounces",
          "BOUNCES: dropped from 1 m, e = 0.8: the time of contact 10",
          "error of the time [s]",
          dropped(from, lossy),
          duration,
          question,
          promised};
}

// ── When is it over? ──

constexpr double slow = 1e-3;  // [m/s]

/// The last contact to which it comes faster.
int last_fast_contact() {
  int k = 0;
  for (long double v = std::sqrt(2 * from * g); v > slow; v *= lossy) ++k;
  return k;
}

double last_fast_time(Simulation& simulation, double h, int steps) {
  double t = 0;
  for (int i = 1; i <= steps; ++i) {
    simulation.advance(1);
    if (!(std::abs(simulation.motion(0).v.z()) <= slow)) t = i * h;
  }
  return t;
}

double last_fast_time(const contact::ContactScene& scene, const contact::ContactRun& run) {
  double t = 0;
  for (const contact::ImpactEvent& impact : run.impacts)
    if (impact.impulse.norm() > slow * (1 + lossy) * scene.body(0).body.mass()) t = impact.t;
  return t;
}

Problem stops() {
  const int k = last_fast_contact();
  const long double truth = time_of_contact(k);
  const auto off = [truth](double t) { return static_cast<double>(std::abs(t - truth)); };
  const Question question{
      [off](Simulation& simulation, double h, int steps) {
        return off(last_fast_time(simulation, h, steps));
      },
      [off](const contact::ContactScene& scene, const contact::ContactRun& run) {
        return off(last_fast_time(scene, run));
      }};
  // As for BOUNCES; what a late contact is off by shifts all later ones, its time by digits/speed.
  const double promised = 16 * eps * (from + 2 * radius) / (slow * (1 - lossy));
  return {"stops",
          "STOPS: dropped from 1 m, e = 0.8: from when on it is slower than 1 mm/s",
          "error of the time [s]",
          dropped(from, lossy),
          5,
          question,
          promised};
}

// ── It lands with a slip ──

Problem slipping(const std::string& name, const std::string& title, double mu) {
  constexpr double height = 0.05, e = 0.5, v = 1, omega = -20, after = 0.05;
  Scene scene = dropped(height, e);
  scene.mu = mu;
  scene.bodies[0].start.v.x() = v;
  scene.bodies[0].start.omega.y() = omega;
  const long double fall = std::sqrt(2 * height / g), slip = v - radius * omega;
  // Per mass: the normal impulse, and that of friction; at 2/7 of the slip the ball rolls.
  const long double normal = (1 + e) * g * fall, rub = std::min(mu * normal, 2 * slip / 7);
  const Vec3 end_v(static_cast<double>(v - rub), 0, static_cast<double>(e * g * fall - g * after));
  const double end_omega = static_cast<double>(omega + rub * 5 / (2 * radius));
  const auto error = [=](const std::vector<Motion>& end) {
    const Vec3 spin = end[0].omega - Vec3(0, end_omega, 0);
    return std::max((end[0].v - end_v).norm(), radius * spin.norm());
  };
  const double duration = static_cast<double>(fall) + after;
  // Rounding of an impact: some tens of operations on numbers of this size.
  const double promised = 100 * eps * (v + radius * std::abs(omega));
  return {name,    title,    "error of its velocities [m/s]",
          scene,   duration, at_end(scene, duration, error),
          promised};
}

// ── Newton's cradle ──

Problem cradle() {
  constexpr double gap = 1e-5, way = 0.1, speed = 1;
  Scene scene;
  scene.planar = true;
  scene.bodies.push_back(ball(radius, 0.5, {-way, 0, 0}, {speed, 0, 0}));
  for (int i = 0; i < 4; ++i)
    scene.bodies.push_back(ball(radius, 0.5, {2 * radius + i * (2 * radius + gap), 0, 0}));
  const auto error = [](const std::vector<Motion>& end) {
    double most = 0;
    for (std::size_t i = 0; i < end.size(); ++i)
      most = std::max(most, (end[i].v - (i == 4 ? speed : 0) * Vec3::UnitX()).norm());
    return most;
  };
  constexpr double duration = 0.2;
  // Of each of four impacts some tens of roundings.
  return {"cradle",
          "CRADLE: Newton's, five balls with gaps of 10 µm, e = 1",
          "error of their velocities [m/s]",
          scene,
          duration,
          at_end(scene, duration, error),
          4 * 100 * eps * speed};
}

}  // namespace

std::vector<Problem> ball_problems() {
  return {for_ever(),
          bounces(),
          stops(),
          slipping("rolls", "ROLLS: a ball with back-spin lands, μ = 0.9: 2/7 of its slip", 0.9),
          slipping("slips", "SLIPS: the same with μ = 0.2: it slips all the time", 0.2),
          cradle()};
}

}  // namespace tumble::bench
