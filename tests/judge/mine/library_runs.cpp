/// @file
/// What the library's methods that take steps make of a problem.
#include <cmath>

#include "judge/mine/library_runs.hpp"
#include "judge/mine/motion_of.hpp"
#include "support/stopwatch.hpp"
#include "tumble/ode.hpp"

namespace tumble::judge::mine {

namespace {

template <class Method_>
Point fixed(const Problem& problem, int steps) {
  return with_motion<double>(problem, [&](const auto& motion) {
    Point point{steps, 0, 0, 0};
    const PackedState<double> start = pack(problem.start);
    const auto run = [&](auto&& f) {
      return integrate_fixed<Method_>(f, start, 0.0, problem.duration, steps);
    };
    point.error = problem.error(run(runge_kutta::CountedRhs(motion, point.evaluations)));
    point.seconds = support::shortest_run(0.01, [&] { support::keep(run(motion)); });
    return point;
  });
}

}  // namespace

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

Point library_run(const Problem& problem, Method method, int steps) {
  switch (method) {
    case Method::euler:
      return fixed<runge_kutta::Euler>(problem, steps);
    case Method::midpoint:
      return fixed<runge_kutta::Midpoint>(problem, steps);
    default:
      return fixed<Rk4>(problem, steps);
  }
}

}  // namespace tumble::judge::mine
