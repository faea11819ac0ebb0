#pragma once
/// @file
/// The motion of a body by a student's functions and by nothing else. It runs in the student's
/// process.

#include <Eigen/LU>
#include <stdexcept>
#include <string>
#include <vector>

#include "01_particles/contract.hpp"
#include "05_momentum/contract.hpp"
#include "09_rigid_body/contract.hpp"
#include "judge/mine/questions.hpp"

namespace tumble::judge::mine {

/// The forces of a setting, by 9.3 and 5.4.
inline rigid_body::WrenchAt wrench_of(const Setting& setting, const rigid_body::Body& body,
                                      int& evaluations) {
  return [&setting, &body, &evaluations](double,
                                         const rigid_body::State& state) -> momentum::Wrench {
    ++evaluations;
    if (setting.stiffness == 0 && setting.gravity.isZero(0) && setting.pull.isZero(0)) {
      return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    }
    const Eigen::Matrix3d R = rigid_body::derived(body, state).R;
    const Eigen::Vector3d pull =
        setting.pull + setting.stiffness * (setting.anchor - (state.x + R * setting.p_body));
    return momentum::net_wrench(body.mass, state.x, R, setting.gravity, {{pull, setting.p_body}});
  };
}

inline Eigen::VectorXd step(Method method, const particles::Rhs& f, double t,
                            const Eigen::VectorXd& y, double h) {
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
  rigid_body::Body body;
  rigid_body::WrenchAt wrench;
  rigid_body::State start;

  /// By 9.5, which takes the steps itself.
  std::vector<Numbers> simulated() const {
    const std::vector<rigid_body::State> states =
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
    const particles::Rhs f = [this](double t, const Eigen::VectorXd& y) -> Eigen::VectorXd {
      return rigid_body::dydt(body, wrench, t, y);
    };
    const double h = question.duration / question.steps;
    const int every = question.steps / question.samples;
    Eigen::VectorXd y = rigid_body::pack(start);
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

inline RunAnswer run(const RunQuestion& question) {
  RunAnswer answer;
  const Setting& setting = question.setting;
  const rigid_body::Body body{setting.mass, setting.inertia, setting.inertia.inverse()};
  const Engine engine{question, body, wrench_of(setting, body, answer.evaluations),
                      rigid_body::unpack(question.start)};
  for (int i = 0; i < question.repeats; ++i) {
    answer.evaluations = 0;
    answer.states = question.method == Method::simulate ? engine.simulated() : engine.stepped();
  }
  return answer;
}

}  // namespace tumble::judge::mine
