// The library's methods: what is added to it is added to the list at the end.
#include "bench/dynamics/as_rigid_body.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/dormand_prince_54.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/rk4.hpp"

namespace tumble::bench {
namespace {

/// What is left of a force where the centre is held: its torque.
struct Held {
  ForceAtBodyPoint push;

  Wrench<> operator()(double t, const RigidBody<>& body, const Derived<>& now) const {
    return {Vec3::Zero(), push(t, body, now).torque};
  }
};

/// Calls use(motion of a body) with the forces that there are: with none where nothing pushes.
template <class Use>
auto with_motion_of(const Scene& scene, const Use& use) {
  if (scene.free()) return use([](const Body& body) { return RigidBodyMotion(rigid_body(body)); });
  return use([held = Held{{scene.push.force, scene.push.p_body}}](const Body& body) {
    return RigidBodyMotion(rigid_body(body), held);
  });
}

template <class Solver>
Method adaptive(const std::string& name, double roundings) {
  const auto prepare = [](const Problem& problem, double tolerance) -> Run {
    const PackedState<double> start = pack(start_of(problem.body()));
    return with_motion_of(problem.scene, [&](const auto& motion_of) -> Run {
      return [=, motion = motion_of(problem.body()), duration = problem.duration] {
        return unpack<double>(
                   integrate_adaptive<Solver>(motion, start, 0.0, duration, {tolerance, tolerance})
                       .y)
            .q;
      };
    });
  };
  return {"tumble", name, Knob::tolerance, prepare, roundings};
}

/// Steps of one length, body after body.
template <class StepMethod, class Motion>
class FixedSteps : public Simulation {
 public:
  FixedSteps(const Scene& scene, const auto& motion_of, double h) : h_(h) {
    for (const Body& body : scene.bodies) {
      motions_.push_back(motion_of(body));
      start_.push_back(pack(start_of(body)));
    }
  }
  void restart() override {
    y_ = start_;
    t_ = 0;
  }
  void advance(int steps) override {
    for (std::size_t b = 0; b < y_.size(); ++b)
      for (int i = 0; i < steps; ++i) y_[b] = StepMethod::step(motions_[b], t_ + i * h_, y_[b], h_);
    t_ += steps * h_;
  }
  Spin spin(std::size_t body) const override {
    const RigidBodyState<> state = unpack<double>(y_[body]);
    const Derived<> now = derived(motions_[body].body(), state);
    return {state.q, now.R.transpose() * now.omega};
  }

 private:
  double h_, t_ = 0;
  std::vector<Motion> motions_;
  std::vector<PackedState<double>> start_, y_;
};

template <class StepMethod>
Stepper fixed_steps(const std::string& name, double roundings) {
  const auto make = [](const Scene& scene, double h) {
    return with_motion_of(scene, [&](const auto& motion_of) -> std::unique_ptr<Simulation> {
      using Motion = decltype(motion_of(scene.bodies.front()));
      return std::make_unique<FixedSteps<StepMethod, Motion>>(scene, motion_of, h);
    });
  };
  return {"tumble", name, make, roundings};
}

}  // namespace

Contestants own_methods() {
  return {{adaptive<DormandPrince54>("DP 5(4)", 1e5), adaptive<Dop853>("DOP853", 1e3)},
          {fixed_steps<Rk4>("RK4", 1e5)}};
}

}  // namespace tumble::bench
