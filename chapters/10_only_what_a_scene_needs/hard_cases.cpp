/// @file
/// Motions that break simulators, and what the library makes of them. The truth is a Taylor series
/// of order 36 in numbers of twice the digits, that of the tests.

#include <cmath>
#include <string>
#include <vector>

#include "parts.hpp"
#include "reference/long_free_turning.hpp"
#include "support/rounding.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/ensemble/advance.hpp"
#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/simulate/first_event.hpp"
#include "tumble/simulate/simulate.hpp"

namespace scene_chapter {

using namespace tumble;
using support::error_number;
using support::number;

namespace {

/// A body in its principal axes, and how it starts: in the origin, its axes along the world's.
struct Case {
  Vec3 J;      ///< [kg m²]
  Vec3 omega;  ///< [rad/s]
  double mass = 1;

  RigidBody<> body() const { return RigidBody<>(mass, Mat3(J.asDiagonal())); }
  RigidBodyState<> start() const {
    return {Vec3::Zero(), Quat(1, 0, 0, 0), Vec3::Zero(), J.cwiseProduct(omega)};
  }
  reference::Turning turning() const { return {J, Quat(1, 0, 0, 0), start().L}; }
};

/// A rounding error, or one that is more than that.
std::string off_by(double angle) {
  if (angle > 0.5) return "lost";
  return (angle < 1e-6 ? support::rounding_number(angle) : error_number(angle)) + " rad";
}

double off(const Quat& q, const Quat& truth) { return angle_between(q.normalized(), truth); }

// ── Flips ──

/// ω₂ of a state: its sign says which way the body is up.
double middle_spin(double, const RigidBodyState<>& s) { return (s.q.conjugate() * s.L).y(); }

/// When a body turned over, as steps saw it: where ω₂ changed its sign, between them in proportion.
class FlipTimes {
 public:
  void operator()(double t, const PackedState<double>& y) {
    const double now = middle_spin(t, unpack<double>(y));
    if (now * before_ < 0) times_.push_back(t - (t - t_) * now / (now - before_));
    t_ = t;
    before_ = now;
  }
  const std::vector<double>& times() const { return times_; }

 private:
  double t_ = 0, before_ = 1;
  std::vector<double> times_;
};

/// The worst of the first ones, as many as both have.
double worst_late(const std::vector<double>& times, const std::vector<double>& truth) {
  double worst = 0;
  for (std::size_t i = 0; i < std::min(times.size(), truth.size()); ++i)
    worst = std::max(worst, std::abs(times[i] - truth[i]));
  return worst;
}

std::string late_text(double seconds) {
  if (seconds > 1) return "lost";
  return (seconds < 1e-8 ? support::rounding_number(seconds) : error_number(seconds)) + " s";
}

}  // namespace

Table hard_flips_table() {
  Table table({"starts off by", "by", "flips in 1000 s", "the first at", "off by", "all off by"});
  constexpr double duration = 1000;
  for (const double tilt : {1e-3, 1e-6, 1e-9}) {
    const Case c{{1, 2, 3}, {tilt, 2, tilt}};
    std::vector<double> ours;
    for (const Event& flip :
         every_event(simulate(c.body(), c.start(), {0, duration, 1e-9}), middle_spin))
      ours.push_back(flip.t);
    const std::vector<double> truth =
        reference::LongFreeTurning(c.turning()).flips(ours.front(), duration);
    FlipTimes steps;
    integrate_adaptive<Dop853>(RigidBodyRhs(c.body()), pack(c.start()), 0.0, duration,
                               {1e-13, 1e-13}, std::ref(steps));
    const auto add = [&](const std::string& name, const std::vector<double>& times) {
      const double first = std::abs(times.front() - truth.front());
      // Between two steps in proportion: no better than 1e-3 s.
      const bool stepped = &times != &ours;
      table.add(
          {number(tilt / 2) + " rad", name,
           std::to_string(times.size()) + " of " + std::to_string(truth.size()),
           number(times.front(), 4) + " s", stepped && first < 0.01 ? "< 0.01 s" : late_text(first),
           times.size() != truth.size()                 ? "lost"
           : stepped && worst_late(times, truth) < 0.01 ? "< 0.01 s"
                                                        : late_text(worst_late(times, truth))});
    };
    add("closed form, events", ours);
    add("DOP853, 1e-13", steps.times());
  }
  return table;
}

// ── One by one ──

namespace {

/// The end of simulate(), asked for 1e-9.
template <class... Forces>
RigidBodyState<> simulated(const Case& c, double t, const Forces&... forces) {
  return simulate(c.body(), c.start(), {0, t, 1e-9}, forces...).end();
}

double free_error(const Case& c, double t) {
  return off(simulated(c, t).q, reference::turned(c.turning(), t).q);
}

double long_error(const Case& c, double t) {
  return off(FreeTrajectory(c.body(), c.start()).at(t).q,
             reference::LongFreeTurning(c.turning()).at(t).q);
}

/// Pulled at a point, everything in proportion to the mass.
double pulled_error(const Case& c, double t) {
  const ForceAtBodyPoint pull{c.mass * Vec3(0, 0, -5), Vec3(0.6, 0, 0.8)};
  reference::Turning truth = c.turning();
  truth.F = pull.force;
  truth.p = pull.p_body;
  return off(simulated(c, t, pull).q, reference::turned(truth, t).q);
}

/// The worst of several.
template <class Error>
double worst(const std::vector<double>& values, const Error& error) {
  double most = 0;
  for (const double value : values) most = std::max(most, error(value));
  return most;
}

}  // namespace

Table hard_cases_table() {
  Table table({"case", "for", "by", "off by"});
  const Vec3 slow(0.3, 0.2, 1);
  const auto add = [&](const std::string& name, const std::string& time, const std::string& by,
                       double error) {
    table.add({name, time, by, off_by(error)});
  };
  add("10⁴ rad/s", "1 s", "closed form", long_error({{1, 2, 3}, {5e3, 7e3, 5e3}}, 1));
  add("10⁴ rad/s", "100 s", "closed form", long_error({{1, 2, 3}, {5e3, 7e3, 5e3}}, 100));
  add("moments 1 : 10⁶ … 10¹²", "10 s", "closed form", worst({1e-6, 1e-9, 1e-12}, [&](double r) {
        return free_error({{r, 1, 1 + r / 2}, slow}, 10);
      }));
  add("equal to 10⁻³ … 10⁻¹⁶", "10 s", "closed form",
      worst({1e-3, 1e-8, 1e-12, 1e-15, 0x1p-52}, [&](double d) {
        return free_error({{1, 1 + d, 1.5}, slow}, 10);
      }));
  add("10⁻⁹ and 10¹² kg, free", "10 s", "closed form", worst({1e-9, 1e12}, [&](double m) {
        return free_error({m * Vec3(1, 2, 3), slow, m}, 10);
      }));
  add("10⁻⁹ and 10¹² kg, pulled at", "10 s", "Taylor series, asked 1e-9",
      worst({1e-9, 1e12}, [&](double m) {
        return pulled_error({m * Vec3(1, 2, 3), slow, m}, 10);
      }));
  const Case tumbling{{1, 2, 3}, {0.5, 1, 0.7}};
  add("a million seconds", "10⁶ s", "closed form", long_error(tumbling, 1e6));
  add("thirty years", "10⁹ s", "closed form", long_error(tumbling, 1e9));
  return table;
}

// ── What no body has ──

Table hard_refused_table() {
  Table table({"moments", "what the library says"});
  const auto add = [&](const std::string& name, const Vec3& moments) {
    std::string said = "nothing: there is such a body";
    try {
      RigidBody<>(1, Mat3(moments.asDiagonal()));
    } catch (const std::invalid_argument& refusal) {
      said = refusal.what();
      said = said.substr(0, said.find(':'));  // behind it come the moments
    }
    table.add({name, said});
  };
  add("1, 2, 3", {1, 2, 3});
  add("1, 2, 3.5", {1, 2, 3.5});
  add("0, 1, 1", {0, 1, 1});
  add("−1, 1, 1", {-1, 1, 1});
  return table;
}

// ── Tops ──

namespace {

/// A top on its tip that leans by `tilt` and spins with a part of the spin that keeps it upright.
struct Top {
  double part, tilt;

  static constexpr double mu = 5;  ///< weight × height [N m]
  static inline const Vec3 J{1, 1, 0.5};
  static double critical() { return std::sqrt(4 * J[0] * mu) / J[2]; }  ///< [rad/s]
  static ForceAtBodyPoint weight() { return {Vec3(0, 0, -mu), Vec3(0, 0, 1)}; }

  RigidBodyState<> start() const {
    const Quat q(std::cos(tilt / 2), std::sin(tilt / 2), 0, 0);
    return {Vec3::Zero(), q, Vec3::Zero(), q * Vec3(0, 0, J[2] * part * critical())};
  }
  Quat truth(double t) const {
    const RigidBodyState<> s = start();
    return reference::turned({J, s.q, s.L, weight().force, weight().p_body}, t).q;
  }
};

}  // namespace

Table hard_tops_table() {
  Table table({"spin ÷ critical", "leans by", "after 10 s", "by", "asked", "off by"});
  constexpr double t = 10, asked = 1e-9;
  const RigidBody<> body(1, Mat3(Top::J.asDiagonal()));
  for (const double part : {1.1, 0.9})
    for (const double tilt : {0.0, 1e-3, 1e-6, 1e-12}) {
      const Top top{part, tilt};
      const Trajectory motion = simulate(body, top.start(), {0, t, asked}, Top::weight());
      const Quat truth = top.truth(t);
      const Vec3 axis = truth * Vec3(0, 0, 1);
      const std::string& method = motion.report().method;
      table.add({number(part), number(tilt) + " rad",
                 number(std::asin(std::hypot(axis.x(), axis.y())), 2) + " rad",
                 motion.report().runs == 0 ? "closed form" : method.substr(0, 13), "1e-09",
                 support::rounding_number(off(motion.end().q, truth)) + " rad"});
    }
  return table;
}

// ── A million steps ──

namespace {

/// The end of 10⁶ steps of 1/60 s. On SSE2: the same digits on every processor.
template <class Method, class... Forces>
RigidBodyState<> million_steps(const RigidBody<>& body, const RigidBodyState<>& start,
                               const Forces&... forces) {
  Ensemble ensemble(std::span(&body, 1), std::span(&start, 1));
  const FixedSteps steps{1.0 / 60, 1'000'000, 0, {1, simd::InstructionSet::baseline}};
  const LostBodies lost = advance<Method>(ensemble, steps, forces...);
  require(lost.count == 0, "lost after a million steps");
  return ensemble.state(0);
}

}  // namespace

Table hard_million_table() {
  Table table({"10⁶ steps of 1/60 s", "energy", "L", "|q|", "orientation"});
  const Case c{{1, 2, 3}, {0.5, 1, 0.7}};
  constexpr double duration = 1e6 / 60;
  const Quat truth = reference::LongFreeTurning(c.turning()).at(duration).q;
  const double energy = kinetic_energy(c.body(), c.start());
  const auto part = [](double error) {
    return error < 1e-10 ? support::rounding_number(error) : error_number(error);
  };
  const auto add = [&](const std::string& name, const RigidBodyState<>& end) {
    table.add({name, part(std::abs(kinetic_energy(c.body(), end) / energy - 1)),
               part((end.L - c.start().L).norm() / c.start().L.norm()),
               part(std::abs(end.q.norm() - 1)), off_by(off(end.q, truth))});
  };
  add("RK4, ensemble", million_steps<Rk4>(c.body(), c.start()));
  add("Magnus series of order 6, ensemble", million_steps<TaylorMagnus<6>>(c.body(), c.start()));
  add("closed form", FreeTrajectory(c.body(), c.start()).at(duration));
  return table;
}

// ── Half the digits ──

namespace {

template <class T>
double minute_by_rk4(const Case& c, int rate, const Quat& truth) {
  const RigidBodyRhs motion(
      RigidBody<T>(MassProperties{c.mass, Vec3::Zero(), Mat3(c.J.asDiagonal())}));
  const PackedState<T> start = pack(c.start()).template cast<T>();
  const RigidBodyState<T> end =
      unpack<T>(integrate_fixed<Rk4>(motion, start, T(0), T(60), 60 * rate));
  return off(Quat(end.q.template cast<double>()), truth);
}

}  // namespace

Table hard_float_table() {
  Table table({"one minute by RK4", "float", "double"});
  const Case c{{1, 2, 3}, {0.5, 1, 0.7}};
  const Quat truth = reference::LongFreeTurning(c.turning()).at(60).q;
  for (const int rate : {10, 30, 60, 240})
    table.add({std::to_string(rate) + " steps per second",
               error_number(minute_by_rk4<float>(c, rate, truth)) + " rad",
               error_number(minute_by_rk4<double>(c, rate, truth)) + " rad"});
  return table;
}

}  // namespace scene_chapter
