/// @file
/// What an evaluation, a step and a motion cost, and what error they buy.

#include "as_matrix_state.hpp"
#include "common.hpp"
#include "momenta_first.hpp"
#include "mug_end.hpp"
#include "parts.hpp"
#include "support/counted.hpp"
#include "support/stopwatch.hpp"
#include "tumble/simulate/simulate.hpp"

namespace rigid_body_chapter {

using support::Counted;

// ── Operations ──

namespace {

template <class T>
Vector3<T> cast(const Vec3& v) {
  return v.cast<T>();
}

template <class T>
RigidBodyState<T> cast_state(const RigidBodyState<>& s) {
  return {cast<T>(s.x), Quaternion<T>(T(s.q.w()), T(s.q.x()), T(s.q.y()), T(s.q.z())), cast<T>(s.P),
          cast<T>(s.L)};
}

const RigidBody<Counted>& counted_mug() {
  static const RigidBody<Counted> body(properties_of(mug_object));
  return body;
}

template <class Action>
std::string operations(Action&& action) {
  return support::text_of(support::count([&] { support::keep(action()); }));
}

}  // namespace

Table counts_table() {
  using C = Counted;
  Table table({"part", "operations"});
  const RigidBody<C>& body = counted_mug();
  const RigidBodyState<C> state = cast_state<C>(mug_start());
  const Derived<C> now = derived(body, state);
  const PackedState<C> y = pack(state);
  const auto motion_of = [&](const auto&... forces) { return RigidBodyRhs(body, forces...); };
  table.add({"R from q", operations([&] { return to_matrix(state.q); })});
  table.add({"ω from L", operations([&] { return angular_velocity(body, now.R, state.L); })});
  table.add({"rate of q from ω",
             operations([&] { return rotation::quaternion_dot(state.q, now.omega); })});
  table.add({"dydt, nothing pushes", operations([&] { return motion_of()(C(0), y); })});
  table.add({"dydt, weight", operations([&] { return motion_of(weight)(C(0), y); })});
  table.add(
      {"dydt, weight and drag", operations([&] { return motion_of(weight, drag)(C(0), y); })});
  table.add({"dydt, weight, drag, spring",
             operations([&] { return motion_of(weight, drag, spring)(C(0), y); })});
  const rotation::MatrixState<C> with_R{state.x, now.R, state.P, state.L};
  table.add({"with R for q, nothing pushes",
             operations([&] { return rotation::MatrixStateRhs(body)(C(0), pack(with_R)); })});
  table.add({"RK4's own, 13 numbers", operations([&] {
               return runge_kutta::rk4_step([](C, const PackedState<C>& z) { return z; }, C(0), y,
                                            C(0.1));
             })});
  return table;
}

// ── Times ──

Table times_table() {
  static PackedState<double> y = pack(mug_start());
  static rotation::PackedMatrixState<double> with_R = pack(as_matrix_state(mug_start()));
  static const RigidBodyRhs lone(mug());
  static const rotation::MatrixStateRhs lone_with_R(mug());
  static const auto motion = hanging_mug();
  static const FreeTrajectory free(handle(), handle_start());
  support::Stopwatch stopwatch;
  const auto add = [&](const std::string& name, auto&& action) {
    stopwatch.add(name, [action] {
      support::keep(y);
      support::keep(with_R);
      support::keep(action());
    });
  };
  add("dydt, nothing pushes", [] { return lone(0, y); });
  add("dydt, weight, drag, spring", [] { return motion(0, y); });
  add("with R for q, nothing pushes", [] { return lone_with_R(0, with_R); });
  add("RK4 step, nothing pushes", [] { return runge_kutta::rk4_step(lone, 0, y, 0.01); });
  add("RK4 step, weight, drag, spring", [] { return runge_kutta::rk4_step(motion, 0, y, 0.01); });
  add("closed form of a free body: set up",
      [] { return FreeTrajectory(handle(), handle_start()); });
  add("closed form of a free body: one time", [] { return free.at(7); });
  const std::vector<support::Timing> timings = stopwatch.timings();
  Table table({"what", "time", "as a ratio"});
  for (const support::Timing& each : timings)
    table.add({each.name, support::duration(each.seconds),
               support::times(each.seconds / timings[0].seconds)});
  return table;
}

// ── Error against evaluations ──

namespace {

/// Where the mug is found, and by how many evaluations of all slopes.
struct Found {
  RigidBodyState<> end;
  int evaluations;
};

double off(const Found& found) { return turned_apart(found.end, mug_end()); }

template <class Method>
Found by_steps(int stages, int steps) {
  return {stepped<Method>(hanging_mug(), mug_start(), mug_time, steps), stages * steps};
}

template <class Method>
Found by_tolerance(double tolerance) {
  const auto solution = integrate_adaptive<Method>(hanging_mug(), pack(mug_start()), 0.0, mug_time,
                                                   {tolerance, tolerance});
  return {unpack<double>(solution.y), solution.evaluations};
}

template <class Method>
support::Series work_of_steps(const std::string& name, int stages) {
  support::Series series{name, {}, {}};
  for (int steps = 8; steps * stages <= 100000; steps = steps * 3 / 2) {
    const Found found = by_steps<Method>(stages, steps);
    if (!(off(found) < 1) || off(found) < 3e-12) continue;
    series.x.push_back(found.evaluations);
    series.y.push_back(off(found));
  }
  return series;
}

template <class Method>
support::Series work_to_tolerances(const std::string& name) {
  support::Series series{name, {}, {}};
  for (int i = 4; i <= 23; ++i) {
    const Found found = by_tolerance<Method>(std::pow(10, -0.5 * i));
    if (off(found) < 3e-12) continue;
    series.x.push_back(found.evaluations);
    series.y.push_back(off(found));
  }
  return series;
}

}  // namespace

std::string work_figure() {
  support::Plot plot{"half a second of the mug on its spring",
                     {"evaluations of dydt", support::Scale::log},
                     {"orientation off by [rad]", support::Scale::log},
                     {}};
  plot.series = {work_of_steps<runge_kutta::Euler>("Euler", 1),
                 work_of_steps<MomentaFirst>("momenta first", 1),
                 work_of_steps<runge_kutta::Midpoint>("midpoint", 2),
                 work_of_steps<Rk4>("RK4", 4),
                 work_to_tolerances<Dop853>("DOP853, adaptive"),
                 work_to_tolerances<DormandPrince54>("DP 5(4), adaptive")};
  return support::to_svg(plot);
}

// ── What simulate() says ──

Table stated_table() {
  Table table({"asked for", "stated", "true", "evaluations", "runs"});
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    SimulationTask task;
    task.t1 = mug_time;
    task.tolerance = tolerance;
    const Trajectory way = simulate(mug(), mug_start(), task, weight, spring, drag);
    const SimulationReport& report = way.report();
    const double true_error = turned_apart(way.end(), mug_end());
    table.add({number(tolerance) + " rad", error_number(report.error_estimate) + " rad",
               true_error < 1e-12 ? "< 1e-12 rad" : error_number(true_error) + " rad",
               std::to_string(report.evaluations), std::to_string(report.runs)});
  }
  return table;
}

// ── Time to an error ──

namespace {

/// Finds the cheapest of a ladder of settings that gets an error, and measures it.
template <class Run>
void add_time_to(Table& table, const std::string& name, const Run& run, int rungs) {
  std::vector<std::string> row{name};
  for (const double wanted : {1e-3, 1e-6, 1e-9}) {
    int rung = 0;
    while (rung < rungs && !(off(run(rung)) <= wanted)) ++rung;
    if (rung == rungs) {
      row.emplace_back("–");
      continue;
    }
    const double seconds = support::shortest_run(0.05, [&] { support::keep(run(rung)); });
    row.push_back(support::duration(seconds));
  }
  table.add(row);
}

}  // namespace

Table race_table() {
  Table table({"method", "1e-3 rad", "1e-6 rad", "1e-9 rad"});
  const auto steps = [](int rung) { return static_cast<int>(8 * std::pow(1.2, rung)); };
  const auto tolerance = [](int rung) { return std::pow(10, -2 - 0.25 * rung); };
  (void)mug_end();
  add_time_to(
      table, "Euler", [&](int rung) { return by_steps<runge_kutta::Euler>(1, steps(rung)); }, 58);
  add_time_to(
      table, "momenta first", [&](int rung) { return by_steps<MomentaFirst>(1, steps(rung)); }, 58);
  add_time_to(
      table, "midpoint", [&](int rung) { return by_steps<runge_kutta::Midpoint>(2, steps(rung)); },
      58);
  add_time_to(
      table, "RK4", [&](int rung) { return by_steps<Rk4>(4, steps(rung)); }, 58);
  add_time_to(
      table, "DP 5(4), adaptive",
      [&](int rung) { return by_tolerance<DormandPrince54>(tolerance(rung)); }, 48);
  add_time_to(
      table, "DOP853, adaptive", [&](int rung) { return by_tolerance<Dop853>(tolerance(rung)); },
      48);
  return table;
}

}  // namespace rigid_body_chapter
