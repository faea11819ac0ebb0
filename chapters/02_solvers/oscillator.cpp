/// @file
/// An oscillator that is stiff now and then.

#include <cmath>

#include "parts.hpp"
#include "problems.hpp"
#include "support/plot.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

namespace {

constexpr VanDerPol oscillator{100};
constexpr double oscillator_time = 200;
constexpr Tolerances oscillator_tolerances{1e-5, 1e-5};

/// (time, step, state at its end) of each step.
struct Step {
  double t, h;
  Vec2 y;
};

template <class Method>
std::vector<Step> oscillator_steps() {
  std::vector<Step> steps;
  double last = 0;
  integrate_adaptive<Method>(oscillator, Vec2(2, 0), 0.0, oscillator_time, oscillator_tolerances,
                             [&](double t, const Vec2& y) {
                               steps.push_back({t, t - last, y});
                               last = t;
                             });
  return steps;
}

}  // namespace

std::string relaxation_figure() {
  const std::vector<Step> steps = oscillator_steps<Radau5>();
  support::Plot plot{"an oscillator that waits and jumps", {"time"}, {"y"}, {}};
  support::Series dense{"y", {0}, {2}};
  integrate_adaptive<Radau5>(
      oscillator, Vec2(2, 0), 0.0, oscillator_time, {1e-8, 1e-8}, [&](double t, const Vec2& y) {
        const bool near = std::hypot(t - dense.x.back(), 30 * (y[0] - dense.y.back())) < 1;
        if (near && t < oscillator_time) return;
        dense.x.push_back(t);
        dense.y.push_back(y[0]);
      });
  support::Series dots{"steps of Radau5", {}, {}, support::Look::dots};
  for (const Step& step : steps) {
    dots.x.push_back(step.t);
    dots.y.push_back(step.y[0]);
  }
  plot.series = {dense, dots};
  return support::to_svg(plot);
}

std::string ridden_figure() {
  support::Plot plot{
      "two solvers of the oscillator", {"time"}, {"length of the step", support::Scale::log}, {}};
  support::Series limit{"3.3 / |λ|", {}, {}}, dp54{"DP 5(4)", {}, {}}, radau{"Radau5", {}, {}};
  for (const Step& step : oscillator_steps<Radau5>()) {
    radau.x.push_back(step.t - step.h / 2);
    radau.y.push_back(step.h);
  }
  const std::vector<Step> steps = oscillator_steps<DormandPrince54>();
  const std::size_t every = steps.size() / 400;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const bool jumps = std::abs(steps[i].y[1]) > 2;
    if (i % (jumps ? 4 : every) != 0) continue;
    const double decay = -oscillator.fastest_decay(steps[i].y);
    dp54.x.push_back(steps[i].t);
    dp54.y.push_back(steps[i].h);
    limit.x.push_back(steps[i].t);
    limit.y.push_back(decay > 0 ? 3.3 / decay : -1);
  }
  plot.series = {dp54, limit, radau};
  return support::to_svg(plot);
}

}  // namespace solvers_chapter
