/// @file
/// An engine that is made of a student's functions and of nothing else: from the mesh to the
/// motion. It runs in the student's process, so nothing that it says is believed but the numbers,
/// and those are measured elsewhere.
#include "judge/mine/questions.hpp"

#include <Eigen/LU>

#include "01_particles/contract.hpp"
#include "05_momentum/contract.hpp"
#include "08_mirtich/contract.hpp"
#include "09_rigid_body/contract.hpp"
#include "10_only_what_a_scene_needs/contract.hpp"
#include "judge/worker/serve.hpp"

namespace {

using namespace tumble::judge;
using namespace tumble::judge::mine;
using Eigen::Vector3d;
using Eigen::VectorXd;
using rigid_body::Body;
using rigid_body::State;

// ── The engine ──

/// The forces of a setting, by 9.3 and 5.4.
rigid_body::WrenchAt wrench_of(const Setting& setting, const Body& body, int& evaluations) {
  return [&setting, &body, &evaluations](double, const State& state) -> momentum::Wrench {
    ++evaluations;
    if (setting.stiffness == 0 && setting.gravity.isZero(0)) {
      return {Vector3d::Zero(), Vector3d::Zero()};
    }
    const Eigen::Matrix3d R = rigid_body::derived(body, state).R;
    const Vector3d pull = setting.stiffness * (setting.anchor - (state.x + R * setting.p_body));
    return momentum::net_wrench(body.mass, state.x, R, setting.gravity, {{pull, setting.p_body}});
  };
}

VectorXd step(Method method, const particles::Rhs& f, double t, const VectorXd& y, double h) {
  switch (method) {
    case Method::euler:
      return particles::euler_step(f, t, y, h);
    case Method::midpoint:
      return particles::midpoint_step(f, t, y, h);
    default:
      return particles::rk4_step(f, t, y, h);
  }
}

struct Engine {
  const RunQuestion& question;
  Body body;
  rigid_body::WrenchAt wrench;
  State start;

  /// By 9.5, which takes the steps itself.
  std::vector<Numbers> simulated() const {
    const std::vector<State> states =
        rigid_body::simulate(body, wrench, start, 0, question.duration, question.steps);
    if (states.size() != static_cast<std::size_t>(question.steps) + 1)
      throw std::length_error("simulate (9.5) returned " + std::to_string(states.size()) +
                              " states for " + std::to_string(question.steps) + " steps");
    std::vector<Numbers> samples;
    const int every = question.steps / question.samples;
    for (int i = 0; i <= question.steps; i += every)
      samples.push_back(rigid_body::pack(states[static_cast<std::size_t>(i)]));
    return samples;
  }

  /// By 9.4 and a step of chapter 1.
  std::vector<Numbers> stepped() const {
    const particles::Rhs f = [this](double t, const VectorXd& y) -> VectorXd {
      return rigid_body::dydt(body, wrench, t, y);
    };
    const double h = question.duration / question.steps;
    const int every = question.steps / question.samples;
    VectorXd y = rigid_body::pack(start);
    std::vector<Numbers> samples{Numbers(y)};
    for (int i = 1; i <= question.steps; ++i) {
      y = step(question.method, f, (i - 1) * h, y, h);
      if (y.size() != 13)
        throw std::length_error("a step returned " + std::to_string(y.size()) +
                                " numbers instead of 13");
      if (i % every == 0) samples.push_back(Numbers(y));
    }
    return samples;
  }
};

RunAnswer run(const RunQuestion& question) {
  RunAnswer answer;
  const Setting& setting = question.setting;
  const Body body{setting.mass, setting.inertia, setting.inertia.inverse()};
  const Engine engine{question, body, wrench_of(setting, body, answer.evaluations),
                      rigid_body::unpack(question.start)};
  for (int i = 0; i < question.repeats; ++i) {
    answer.evaluations = 0;
    answer.states = question.method == Method::simulate ? engine.simulated() : engine.stepped();
  }
  return answer;
}

// ── The other questions ──

mirtich::MassProperties mass(const mirtich::Polyhedron& mesh, double density, int repeats) {
  mirtich::MassProperties result{};
  for (int i = 0; i < repeats; ++i) result = mirtich::mass_properties(mesh, density);
  return result;
}

Eigen::Vector4d top(double A, double C, const Eigen::Vector4d& q0, const Vector3d& L, double t,
                    int repeats) {
  Eigen::Vector4d q = q0;
  for (int i = 0; i < repeats; ++i) q = only_what_a_scene_needs::free_symmetric_top(A, C, q0, L, t);
  return q;
}

only_what_a_scene_needs::EnergyDrift drift(const Setting& setting,
                                           const std::vector<Numbers>& states, double h) {
  std::vector<State> unpacked;
  for (const Numbers& y : states) unpacked.push_back(rigid_body::unpack(y));
  return only_what_a_scene_needs::energy_drift(
      {setting.mass, setting.inertia, setting.inertia.inverse()}, unpacked, h);
}

template <class Result, class... Arguments>
Value answered(Result (*function)(Arguments...), const List& arguments) {
  return answer_with(function, arguments, std::index_sequence_for<Arguments...>{});
}

Value answer(const List& question) {
  const List arguments(question.begin() + 1, question.end());
  switch (from_value<Topic>(question.at(0))) {
    case Topic::mass:
      return answered(mass, arguments);
    case Topic::run:
      return answered(run, arguments);
    case Topic::top:
      return answered(top, arguments);
    case Topic::choose:
      return answered(only_what_a_scene_needs::choose_model, arguments);
    case Topic::drift:
      return answered(drift, arguments);
  }
  throw Malformed("the judge asked for something that there is not");
}

}  // namespace

int main() { return serve_questions(answer); }
