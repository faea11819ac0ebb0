#include "judge/mine/problem.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "objects/objects.hpp"
#include "support/stopwatch.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"
#include "tumble/simulate/simulate.hpp"

namespace tumble::judge::mine {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Calls `action` with the right-hand side of the problem's motion, in the scalar T.
template <class T, class Action>
auto with_motion(const Problem& problem, Action&& action) {
  const RigidBody<T> body(problem.exact);
  using End = decltype(action(RigidBodyMotion(body)));
  if (!problem.pull) return action(RigidBodyMotion(body));
  return End(action(RigidBodyMotion(body, Weight{problem.pull->gravity}, problem.pull->spring)));
}

/// The best method, in long double where that is more than double, at the tightest tolerance.
Quat true_end(const Problem& problem) {
  using Real = long double;
  constexpr double eps = static_cast<double>(std::numeric_limits<Real>::epsilon());
  const double tolerance = std::max(1e-18, 4 * eps);
  const PackedState<Real> start = pack(problem.start).cast<Real>();
  const auto end = with_motion<Real>(problem, [&](const auto& motion) -> PackedState<Real> {
    return integrate_adaptive<Dop853>(motion, start, Real(0), Real(problem.duration),
                                      {tolerance, tolerance})
        .y;
  });
  return normalize(unpack<double>(PackedState<double>(end.cast<double>())).q);
}

/// Turning about the given body axes' directions in the world, which are the principal ones.
RigidBodyState<> spinning(const RigidBody<>& body, const Vec3& omega) {
  const PrincipalAxes axes = principal_axes(body.I_body());
  const Quat q = from_matrix(axes.R).conjugate();
  return state_of_motion<double>(body, Vec3::Zero(), q, Vec3::Zero(), omega);
}

struct Plan {
  std::string name, title, sentence;
  const objects::Object& object;
  Vec3 omega;  ///< about the principal axes, the least moment first [rad/s]
  double duration;
  std::optional<Pull> pull;
  Model model;
};

Problem made(const Plan& plan) {
  constexpr int resolution = 2;  // a thousand faces and more
  const PolygonMesh mesh = plan.object.mesh(resolution);
  const MassProperties exact = unchecked_mass_properties(mesh, plan.object.density);
  const RigidBody<> body(exact);
  Problem problem{plan.name,           plan.title, plan.sentence, mesh,
                  plan.object.density, exact,      body,          spinning(body, plan.omega),
                  plan.duration,       plan.pull,  plan.model,    Quat::Identity()};
  problem.end = true_end(problem);
  return problem;
}

template <class Method_>
Point fixed(const Problem& problem, int steps) {
  return with_motion<double>(problem, [&](const auto& motion) {
    Point point{steps, 0, 0, 0};
    const PackedState<double> start = pack(problem.start);
    const auto run = [&](auto&& f) {
      return integrate_fixed<Method_>(f, start, 0.0, problem.duration, steps);
    };
    point.error = problem.error(run(CountedRhs(motion, point.evaluations)));
    point.seconds = support::shortest_run(0.01, [&] { support::keep(run(motion)); });
    return point;
  });
}

Point dop853(const Problem& problem, double tolerance) {
  return with_motion<double>(problem, [&](const auto& motion) {
    const PackedState<double> start = pack(problem.start);
    const auto run = [&] {
      return integrate_adaptive<Dop853>(motion, start, 0.0, problem.duration,
                                        {tolerance, tolerance});
    };
    const auto solution = run();
    return Point{solution.steps, solution.evaluations,
                 support::shortest_run(0.01, [&] { support::keep(run().y); }),
                 problem.error(solution.y)};
  });
}

Trajectory simulated(const Problem& problem, double tolerance) {
  const SimulationTask task{0, problem.duration, tolerance, Wanted::motion};
  if (!problem.pull) return simulate(problem.body, problem.start, task);
  return simulate(problem.body, problem.start, task, Weight{problem.pull->gravity},
                  problem.pull->spring);
}

Point by_simulate(const Problem& problem, double tolerance) {
  const Trajectory trajectory = simulated(problem, tolerance);
  const SimulationReport& report = trajectory.report();
  return {report.steps, report.evaluations,
          support::shortest_run(0.01, [&] { support::keep(simulated(problem, tolerance).end()); }),
          problem.error(pack(trajectory.end()))};
}

}  // namespace

double Problem::error(const Numbers& y) const {
  const Quat q(y[3], y[4], y[5], y[6]);
  if (!y.allFinite() || q.squaredNorm() == 0) return std::numeric_limits<double>::quiet_NaN();
  return angle_between(normalize(q), end);
}

double Problem::energy(const Numbers& y, const MassProperties& properties) const {
  const RigidBodyState<> state = unpack<double>(y);
  const RigidBody<> measured(properties);
  double sum = kinetic_energy(measured, state);
  if (!pull) return sum;
  const Vec3 p = point_position(tumble::derived(measured, state), pull->spring.p_body);
  sum -= measured.mass() * pull->gravity.dot(state.x);
  return sum + pull->spring.stiffness * (pull->spring.anchor - p).squaredNorm() / 2;
}

std::vector<Problem> problems() {
  const objects::Object &handle = objects::all[0], &gear = objects::all[4];
  const Vec3 nearly_middle = turn * Vec3(0.01, 1, -0.01);
  const Pull pull{{0, 0, -9.80665}, {{0, 0.005, 0}, {0, 0, 0.3}, 4, 0}};
  return {made({"free",
                "T-handle, free",
                "a T-handle that nothing pushes, spun about its middle axis",
                handle,
                nearly_middle,
                3,
                {},
                Model::full_body}),
          made({"spring", "T-handle on a spring",
                "the same T-handle, hung from a spring beside its centre", handle, nearly_middle, 2,
                pull, Model::full_body}),
          made({"top",
                "gear, free",
                "a gear that nothing pushes: two of its moments are equal",
                gear,
                turn * Vec3(0.6, 0, 2),
                3,
                {},
                Model::symmetric_top})};
}

Point library_run(const Problem& problem, Method method, int steps) {
  switch (method) {
    case Method::euler:
      return fixed<Euler>(problem, steps);
    case Method::midpoint:
      return fixed<Midpoint>(problem, steps);
    default:
      return fixed<Rk4>(problem, steps);
  }
}

std::vector<Curve> library_curves(const Problem& problem) {
  std::vector<Curve> curves{{"RK4", false, {}}, {"DOP853", false, {}}};
  for (int steps = 32; steps <= 8192; steps *= 2)
    curves[0].points.push_back(library_run(problem, Method::rk4, steps));
  for (int digits = 2; digits <= 14; ++digits)
    curves[1].points.push_back(dop853(problem, std::pow(10.0, -digits)));
  if (problem.pull) {
    curves.push_back({"simulate()", false, {}});
    for (int digits = 3; digits <= 12; ++digits)
      curves.back().points.push_back(by_simulate(problem, std::pow(10.0, -digits)));
  } else {
    curves.push_back({"closed form", false, {by_simulate(problem, 1e-12)}});
  }
  return curves;
}

}  // namespace tumble::judge::mine
