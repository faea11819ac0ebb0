// Boost.odeint: its adaptive methods, two of fixed steps, on the plain motion.
#include <boost/numeric/odeint.hpp>

#include "project/bench/dynamics/peers/plain_rhs.hpp"

namespace tumble::bench {
namespace {

namespace odeint = boost::numeric::odeint;

const std::string software = "Boost.odeint";

/// @param solve called as solve(motion, y, duration, tolerance)
template <class Solve>
Method adaptive(const std::string& name, const Solve& solve) {
  const auto prepare = [solve](const Problem& problem, double tolerance) {
    return with_plain_rhs(problem.scene, [&]<class Rhs>() -> Run {
      return [=, motion = Rhs(problem.body(), problem.scene.push),
              start = plain_state(problem.body().start), duration = problem.duration] {
        PlainState y = start;
        solve(motion, y, duration, tolerance);
        return plain_spin(y).q;
      };
    });
  };
  return {software, name, Knob::tolerance, prepare};
}

template <class ErrorStepper>
Method controlled(const std::string& name) {
  return adaptive(name, [](const auto& motion, PlainState& y, double duration, double tolerance) {
    odeint::integrate_adaptive(odeint::make_controlled<ErrorStepper>(tolerance, tolerance), motion,
                               y, 0.0, duration, 1e-3);
  });
}

Method bulirsch_stoer() {
  const auto solve = [](const auto& motion, PlainState& y, double duration, double tolerance) {
    odeint::integrate_adaptive(odeint::bulirsch_stoer<PlainState>(tolerance, tolerance), motion, y,
                               0.0, duration, 1e-3);
  };
  return adaptive("bulirsch_stoer", solve);
}

/// Steps of one length, body after body.
template <class Method, class Rhs>
class FixedSteps : public Simulation {
 public:
  FixedSteps(const Scene& scene, double h) : h_(h) {
    for (const Body& body : scene.bodies) {
      motions_.push_back(Rhs(body, scene.push));
      start_.push_back(plain_state(body.start));
    }
  }
  void restart() override {
    y_ = start_;
    methods_.assign(y_.size(), Method());
  }
  void advance(int steps) override {
    for (std::size_t b = 0; b < y_.size(); ++b)
      for (int i = 0; i < steps; ++i) methods_[b].do_step(motions_[b], y_[b], i * h_, h_);
  }
  Spin spin(std::size_t body) const override { return plain_spin(y_[body]); }

 private:
  double h_;
  std::vector<Rhs> motions_;
  std::vector<Method> methods_;
  std::vector<PlainState> start_, y_;
};

template <class Method>
Stepper fixed_steps(const std::string& name) {
  const auto make = [](const Scene& scene, double h) {
    return with_plain_rhs(scene, [&]<class Rhs>() -> std::unique_ptr<Simulation> {
      return std::make_unique<FixedSteps<Method, Rhs>>(scene, h);
    });
  };
  return {software, name, make};
}

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(tumble::bench::Contestants& contestants) {
  using namespace tumble::bench;
  contestants.methods.push_back(
      controlled<odeint::runge_kutta_fehlberg78<PlainState>>("runge_kutta_fehlberg78"));
  contestants.methods.push_back(
      controlled<odeint::runge_kutta_dopri5<PlainState>>("runge_kutta_dopri5"));
  contestants.methods.push_back(bulirsch_stoer());
  contestants.steppers.push_back(fixed_steps<odeint::runge_kutta4<PlainState>>("runge_kutta4"));
  contestants.steppers.push_back(
      fixed_steps<odeint::adams_bashforth_moulton<8, PlainState>>("adams_bashforth_moulton8"));
}
