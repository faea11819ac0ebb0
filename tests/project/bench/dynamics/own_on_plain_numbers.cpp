// The library's solvers on the right-hand side that the peers' solvers get, so that a row beside
// theirs compares solvers. What a RigidBodyRhs costs more, the rows of own_methods.cpp say.
#include "project/bench/dynamics/own_on_plain_numbers.hpp"

#include "project/bench/dynamics/peers/plain_rhs.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/dormand_prince_54.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/rk4.hpp"

namespace tumble::bench {
namespace {

using Numbers = Eigen::Matrix<double, 7, 1>;

Numbers numbers(const Spin& spin) {
  const PlainState plain = plain_state(spin);
  return Eigen::Map<const Numbers>(plain.data());
}

Spin spin_of(const Numbers& y) {
  PlainState plain;
  Eigen::Map<Numbers>(plain.data()) = y;
  return plain_spin(plain);
}

/// As the library calls it.
template <class Plain>
struct AsRhs {
  Plain plain;

  Numbers operator()(double, const Numbers& y) const {
    Numbers dydt;
    plain(y.data(), dydt.data());
    return dydt;
  }
};

template <class Solver>
Method adaptive(const std::string& name) {
  const auto prepare = [](const Problem& problem, double tolerance) -> Run {
    return with_plain_rhs(problem.scene, [&]<class Plain>() -> Run {
      return [=, rhs = AsRhs<Plain>{Plain(problem.body(), problem.scene.push)},
              start = numbers(problem.body().start), duration = problem.duration] {
        return spin_of(
                   integrate_adaptive<Solver>(rhs, start, 0.0, duration, {tolerance, tolerance}).y)
            .q;
      };
    });
  };
  return {"tumble", name, Knob::tolerance, prepare};
}

/// Steps of one length, body after body.
template <class Plain>
class FixedSteps : public Simulation {
 public:
  FixedSteps(const Scene& scene, double h) : h_(h) {
    for (const Body& body : scene.bodies) {
      motions_.push_back({Plain(body, scene.push)});
      start_.push_back(numbers(body.start));
    }
  }
  void restart() override { y_ = start_; }
  void advance(int steps) override {
    for (std::size_t b = 0; b < y_.size(); ++b)
      for (int i = 0; i < steps; ++i) y_[b] = Rk4::step(motions_[b], i * h_, y_[b], h_);
  }
  Spin spin(std::size_t body) const override { return spin_of(y_[body]); }

 private:
  double h_;
  std::vector<AsRhs<Plain>> motions_;
  std::vector<Numbers> start_, y_;
};

Stepper rk4() {
  const auto make = [](const Scene& scene, double h) {
    return with_plain_rhs(scene, [&]<class Plain>() -> std::unique_ptr<Simulation> {
      return std::make_unique<FixedSteps<Plain>>(scene, h);
    });
  };
  return {"tumble", "RK4, plain numbers", make};
}

}  // namespace

void add_own_on_plain_numbers(Contestants& contestants) {
  contestants.methods.push_back(adaptive<DormandPrince54>("DP 5(4), plain numbers"));
  contestants.methods.push_back(adaptive<Dop853>("DOP853, plain numbers"));
  contestants.steppers.push_back(rk4());
}

}  // namespace tumble::bench
