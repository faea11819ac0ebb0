// The library's methods: what is added to it is added to the list at the end.
#include "project/bench/dynamics/as_rigid_body.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/ensemble/advance.hpp"
#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/geometric/lie_group_rk4.hpp"
#include "tumble/geometric/splitting.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/dormand_prince_54.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/rk4.hpp"
#include "tumble/simulate/simulate.hpp"

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
  if (scene.free()) return use([](const Body& body) { return RigidBodyRhs(rigid_body(body)); });
  return use([held = Held{{scene.push.force, scene.push.p_body}}](const Body& body) {
    return RigidBodyRhs(rigid_body(body), held);
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
template <class StepMethod, class Rhs>
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
  std::vector<Rhs> motions_;
  std::vector<PackedState<double>> start_, y_;
};

template <class StepMethod>
Stepper fixed_steps(const std::string& name, double roundings) {
  const auto make = [](const Scene& scene, double h) {
    return with_motion_of(scene, [&](const auto& motion_of) -> std::unique_ptr<Simulation> {
      using Rhs = decltype(motion_of(scene.bodies.front()));
      return std::make_unique<FixedSteps<StepMethod, Rhs>>(scene, motion_of, h);
    });
  };
  return {"tumble", name, make, roundings};
}

/// Bodies that take steps by `step(motion, t, state, h)`.
template <class Rhs, class Step>
class GeometricSteps : public Simulation {
 public:
  GeometricSteps(const Scene& scene, const auto& motion_of, double h) : h_(h) {
    for (const Body& body : scene.bodies) {
      motions_.push_back(motion_of(body));
      steps_.emplace_back(motions_.back());
      start_.push_back(start_of(body));
    }
  }
  void restart() override {
    states_ = start_;
    t_ = 0;
  }
  void advance(int steps) override {
    for (std::size_t b = 0; b < states_.size(); ++b)
      for (int i = 0; i < steps; ++i) states_[b] = steps_[b].step(t_ + i * h_, states_[b], h_);
    t_ += steps * h_;
  }
  Spin spin(std::size_t body) const override {
    const Derived<> now = derived(motions_[body].body(), states_[body]);
    return {states_[body].q, now.R.transpose() * now.omega};
  }

 private:
  double h_, t_ = 0;
  std::vector<Rhs> motions_;
  std::vector<Step> steps_;
  std::vector<RigidBodyState<>> start_, states_;
};

/// LieGroupRk4 for one motion.
template <class Rhs>
struct TurnSteps {
  Rhs motion;
  explicit TurnSteps(const Rhs& m) : motion(m) {}
  RigidBodyState<> step(double t, const RigidBodyState<>& state, double h) const {
    return geometric::LieGroupRk4::step(motion, t, state, h);
  }
};

template <class Scheme, class... Forces>
geometric::Splitting<Scheme, Forces...> splitting_of(const RigidBodyRhs<double, Forces...>&);
template <class Scheme, class Rhs>
using SplittingOf = decltype(splitting_of<Scheme>(std::declval<Rhs>()));

template <template <class> class StepOf>
Stepper geometric_steps(const std::string& name, double roundings) {
  const auto make = [](const Scene& scene, double h) {
    return with_motion_of(scene, [&](const auto& motion_of) -> std::unique_ptr<Simulation> {
      using Rhs = decltype(motion_of(scene.bodies.front()));
      return std::make_unique<GeometricSteps<Rhs, StepOf<Rhs>>>(scene, motion_of, h);
    });
  };
  return {"tumble", name, make, roundings};
}
template <class Rhs>
using Splitting4 = SplittingOf<geometric::BlanesMoan4, Rhs>;
template <class Rhs>
using Splitting6 = SplittingOf<geometric::BlanesMoan6, Rhs>;

/// All bodies of a scene side by side in vector lanes.
template <class EnsembleMethod>
class EnsembleSteps : public Simulation {
 public:
  EnsembleSteps(const Scene& scene, double h, int threads)
      : push_{scene.push.force, scene.push.p_body}, free_(scene.free()), h_(h), threads_(threads) {
    std::vector<RigidBodyState<>> states;
    for (const Body& body : scene.bodies) {
      bodies_.push_back(rigid_body(body));
      states.push_back(start_of(body));
    }
    start_.emplace(bodies_, states);
  }
  void restart() override {
    now_ = start_;
    t_ = 0;
  }
  void advance(int steps) override {
    const tumble::FixedSteps all{h_, steps, t_, {.threads = threads_}};
    // The centres, which the push moves too, are nobody's concern here.
    const LostBodies lost = free_ ? tumble::advance<EnsembleMethod>(*now_, all)
                                  : tumble::advance<EnsembleMethod>(*now_, all, push_);
    require(lost.count == 0, "the ensemble lost ", lost.count, " bodies");
    t_ += steps * h_;
  }
  Spin spin(std::size_t body) const override {
    const RigidBodyState<> state = now_->state(body);
    return {state.q, bodies_[body].I_body_inv() * (state.q.conjugate() * state.L)};
  }

 private:
  ForceAtBodyPoint push_;
  bool free_;
  double h_, t_ = 0;
  int threads_;
  std::vector<RigidBody<>> bodies_;
  std::optional<Ensemble> start_, now_;
};

template <class EnsembleMethod>
Stepper ensemble_steps(const std::string& name, int threads = 1) {
  const auto make = [threads](const Scene& scene, double h) {
    return std::make_unique<EnsembleSteps<EnsembleMethod>>(scene, h, threads);
  };
  return {"tumble", name, make, 1e5};
}

/// What pushes the bodies of a scene, their centres held.
SteadyForces held_forces(const Scene& scene) {
  SteadyForces forces;
  if (!scene.free()) forces.at_point.push_back({scene.push.force, scene.push.p_body});
  return forces;
}

/// The free motion, set up and asked once.
Method free_closed_form() {
  const auto prepare = [](const Problem& problem, double) -> Run {
    if (!problem.scene.free()) return {};
    return [body = rigid_body(problem.body()), start = start_of(problem.body()),
            t = problem.duration] { return detail::FreeFlow(body).advance(start.q, start.L, t); };
  };
  return {"tumble", "closed form", Knob::tolerance, prepare, 1e3};
}

/// The free motion once more, for one that is set up.
Method free_evaluation() {
  const auto prepare = [](const Problem& problem, double) -> Run {
    if (!problem.scene.free()) return {};
    return [motion = FreeTrajectory(rigid_body(problem.body()), start_of(problem.body())),
            t = problem.duration] { return motion.at(t).q; };
  };
  return {"tumble", "one more", Knob::tolerance, prepare, 1e3};
}

/// The heavy symmetric top, set up and asked once.
Method top_closed_form() {
  const auto prepare = [](const Problem& problem, double) -> Run {
    const RigidBody<> body = rigid_body(problem.body());
    const RigidBodyState<> start = start_of(problem.body());
    const SteadyForces forces = held_forces(problem.scene);
    if (!steady::LagrangeTop::from(steady::SteadyTorque(body, forces), start.q, start.L)) return {};
    return [=, t = problem.duration] {
      return steady::LagrangeTop::from(steady::SteadyTorque(body, forces), start.q, start.L)
          ->at(t)
          .q;
    };
  };
  return {"tumble", "closed form", Knob::tolerance, prepare, 1e3};
}

template <int rank>
Quat end_of_series(const steady::SteadyTorque& torque, const RigidBodyState<>& start, double t,
                   double tolerance) {
  const steady::TurningBySeries<rank> turning(torque, torque.turning(start.q, start.L), 0, t,
                                              tolerance);
  return torque.orientation(turning.end());
}

Method taylor_series() {
  const auto prepare = [](const Problem& problem, double tolerance) -> Run {
    const steady::SteadyTorque torque(rigid_body(problem.body()), held_forces(problem.scene));
    return [=, start = start_of(problem.body()), t = problem.duration] {
      return torque.rank() == 0 ? end_of_series<0>(torque, start, t, tolerance)
                                : end_of_series<1>(torque, start, t, tolerance);
    };
  };
  return {"tumble", "Taylor series", Knob::tolerance, prepare, 1e3};
}

/// The error of the whole span stated and kept: what users call.
Method stated() {
  const auto prepare = [](const Problem& problem, double tolerance) -> Run {
    return [body = rigid_body(problem.body()), start = start_of(problem.body()),
            forces = held_forces(problem.scene), t = problem.duration, tolerance] {
      return simulate(body, start, {0, t, tolerance}, forces).end().q;
    };
  };
  return {"tumble", "simulate()", Knob::tolerance, prepare, 1e3};
}

/// The same, told nothing of what the force is.
Method stated_for_any_force() {
  const auto prepare = [](const Problem& problem, double tolerance) -> Run {
    if (problem.scene.free()) return {};
    return [body = rigid_body(problem.body()), start = start_of(problem.body()),
            held = Held{{problem.scene.push.force, problem.scene.push.p_body}},
            t = problem.duration, tolerance] {
      return simulate(body, start, {0, t, tolerance}, held).end().q;
    };
  };
  return {"tumble", "simulate(), any force", Knob::tolerance, prepare, 1e3};
}

}  // namespace

Contestants own_methods() {
  return {
      {free_closed_form(), free_evaluation(), top_closed_form(), taylor_series(), stated(),
       stated_for_any_force(), adaptive<DormandPrince54>("DP 5(4)", 1e5),
       adaptive<Dop853>("DOP853", 1e3)},
      {fixed_steps<Rk4>("RK4", 1e5), geometric_steps<Splitting4>("splitting of order 4", 1e5),
       geometric_steps<Splitting6>("splitting of order 6", 1e5),
       geometric_steps<TurnSteps>("Lie-group RK4", 1e5),
       ensemble_steps<tumble::Rk4>("ensemble, RK4"), ensemble_steps<TaylorMagnus<4>>("Magnus 4"),
       ensemble_steps<TaylorMagnus<6>>("Magnus 6"), ensemble_steps<TaylorMagnus<8>>("Magnus 8"),
       ensemble_steps<TaylorMagnus<4>>("Magnus 4, 2 threads", 2)}};
}

}  // namespace tumble::bench
