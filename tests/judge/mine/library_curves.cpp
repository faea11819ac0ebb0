#include <cmath>

#include "judge/mine/library_runs.hpp"

namespace tumble::judge::mine {

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
