/// @file
/// Where steps and right-hand sides fail.

#include "common.hpp"
#include "objects/hanging_mug.hpp"
#include "parts.hpp"

namespace rigid_body_chapter {

// ── A thousand seconds ──

namespace {

/// How often the handle has turned over in the states that `visit` shows one after the other.
class FlipCounter {
 public:
  void operator()(double, const PackedState<double>& y) {
    const double now = omega_principal(handle(), unpack<double>(y))[1];
    flips_ += now * before_ < 0;
    before_ = now;
  }
  int flips() const { return flips_; }

 private:
  int flips_ = 0;
  double before_ = 1;
};

}  // namespace

Table thousand_table() {
  Table table({"by", "evaluations", "turned over", "orientation off at the end"});
  constexpr double duration = 1000;
  const RigidBodyRhs motion(handle());
  const PackedState<double> start = pack(handle_start());
  const FreeTrajectory truth(handle(), handle_start());
  const auto add = [&](const std::string& name, int evaluations, int flips,
                       const PackedState<double>& end) {
    const double angle = turned_apart(unpack<double>(end), truth.at(duration));
    table.add({name, std::to_string(evaluations), std::to_string(flips) + " times",
               angle > 0.5 ? "lost" : error_number(angle) + " rad"});
  };
  for (const int rate : {20, 60, 240}) {
    FlipCounter counter;
    const int steps = rate * static_cast<int>(duration);
    const auto end = integrate_fixed<Rk4>(motion, start, 0, duration, steps, std::ref(counter));
    add("RK4, " + std::to_string(rate) + " steps per second", 4 * steps, counter.flips(), end);
  }
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    FlipCounter counter;
    const auto solution = integrate_adaptive<Dop853>(motion, start, 0.0, duration,
                                                     {tolerance, tolerance}, std::ref(counter));
    add("DOP853, tolerance " + number(tolerance), solution.evaluations, counter.flips(),
        solution.y);
  }
  FlipCounter counter;
  for (int i = 0; i <= 10 * static_cast<int>(duration); ++i) counter(0, pack(truth.at(0.1 * i)));
  table.add({"closed form", "–", std::to_string(counter.flips()) + " times", "–"});
  return table;
}

// ── A force that begins ──

namespace {

constexpr double switched_at = 0.3;  // [s]

/// A motor that turns the handle about the world's x axis, from a moment on.
auto motor() {
  return [](double t, const RigidBody<>&, const Derived<>&) -> Wrench<> {
    return {Vec3::Zero(), Vec3(t < switched_at ? 0 : 0.002, 0, 0)};
  };
}

}  // namespace

Table begins_table() {
  Table table({"RK4", "60 steps per second", "120", "240", "480"});
  const RigidBodyRhs motion(handle(), motor());
  const auto in_two_parts = [&](auto&& part) {
    PackedState<double> y = part(pack(handle_start()), 0.0, switched_at);
    return part(y, switched_at, 1.0);
  };
  const auto before = RigidBodyRhs(handle());
  const auto after =
      RigidBodyRhs(handle(), [](double, const RigidBody<>&, const Derived<>&) -> Wrench<> {
        return {Vec3::Zero(), Vec3(0.002, 0, 0)};
      });
  const auto exact = in_two_parts([&](const PackedState<double>& y, double t0, double t1) {
    return t0 == 0 ? integrate_adaptive<Dop853>(before, y, t0, t1, {1e-13, 1e-13}).y
                   : integrate_adaptive<Dop853>(after, y, t0, t1, {1e-13, 1e-13}).y;
  });
  const auto angle = [&](const PackedState<double>& y) {
    return error_number(turned_apart(unpack<double>(y), unpack<double>(exact))) + " rad";
  };
  std::vector<std::string> across{"steps across the beginning"}, upto{"a step ends at 0.3 s"};
  for (const int rate : {60, 120, 240, 480}) {
    // One step less, so that no step ends by chance where the motor begins.
    across.push_back(angle(integrate_fixed<Rk4>(motion, pack(handle_start()), 0, 1, rate - 1)));
    upto.push_back(angle(in_two_parts([&](const PackedState<double>& y, double t0, double t1) {
      const int steps = static_cast<int>(std::lround((t1 - t0) * rate));
      return t0 == 0 ? integrate_fixed<Rk4>(before, y, t0, t1, steps)
                     : integrate_fixed<Rk4>(after, y, t0, t1, steps);
    })));
  }
  table.add(across);
  table.add(upto);
  return table;
}

// ── Too much of a turn in a step ──

Table fast_table() {
  Table table({"steps per turn", "radians per step", "orientation off", "energy", "|q|"});
  // Mostly about the axis of the least moment: stable, with a wobble.
  const Quat q = from_matrix(principal_axes(handle().I_body()).R).conjugate();
  const RigidBodyState<> start = state_of_motion<double>(handle(), Vec3::Zero(), q, Vec3::Zero(),
                                                         2 * pi * Vec3(0.95, 0.2, 0.2));
  const double energy = kinetic_energy(handle(), start);
  constexpr int turns = 20;
  const RigidBodyState<> exact = FreeTrajectory(handle(), start).at(turns);
  for (const int rate : {64, 32, 16, 8, 4, 2}) {
    const RigidBodyState<> end = stepped<Rk4>(RigidBodyRhs(handle()), start, turns, turns * rate);
    const double change = kinetic_energy(handle(), end) / energy - 1;
    table.add({std::to_string(rate), number(2 * pi / rate, 2),
               error_number(turned_apart(end, exact)) + " rad", error_number(change),
               number(end.q.norm(), 3)});
  }
  return table;
}

// ── Honey ──

Table honey_table() {
  Table table({"method", "evaluations", "ω after one second"});
  const BodyDrag honey{30, 0.5};
  const RigidBodyRhs motion(mug(), weight, honey);
  const auto text = [](const PackedState<double>& y) {
    const double spin = derived(mug(), unpack<double>(y)).omega.norm();
    return std::isfinite(spin) && spin < 1e3
               ? (spin < 1e-4 ? "< 1e-4 rad/s" : number(spin, 2) + " rad/s")
               : std::string("blows up");
  };
  for (const int rate : {240, 360, 480, 960})
    table.add({"RK4, " + std::to_string(rate) + " steps", std::to_string(4 * rate),
               text(integrate_fixed<Rk4>(motion, pack(mug_start()), 0, 1, rate))});
  const auto explicitly =
      integrate_adaptive<Dop853>(motion, pack(mug_start()), 0.0, 1.0, {1e-6, 1e-9});
  table.add({"DOP853, adaptive", std::to_string(explicitly.evaluations), text(explicitly.y)});
  const auto implicitly =
      integrate_adaptive<Radau5>(motion, pack(mug_start()), 0.0, 1.0, {1e-6, 1e-9});
  table.add({"Radau5, implicit", std::to_string(implicitly.evaluations), text(implicitly.y)});
  return table;
}

}  // namespace rigid_body_chapter
