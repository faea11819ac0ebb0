#pragma once

#include "tumble/simulate/write_states.hpp"

#include "tumble/body/derived.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY void write_csv_numbers(std::ostream& out, const RigidBody<>& body,
                                   const RigidBodyState<>& state) {
  const Derived<> now = derived(body, state);
  Eigen::Matrix<double, 19, 1> numbers;
  numbers << state.x, coefficients(state.q), now.v, now.omega, state.P, state.L;
  write_numbers(out, numbers);
}

TUMBLE_BODY void write_json_members(std::ostream& out, const RigidBody<>& body,
                                    const RigidBodyState<>& state) {
  const Derived<> now = derived(body, state);
  const auto member = [&](const char* name, const auto& numbers) {
    out << '"' << name << "\":[";
    write_numbers(out, numbers);
    out << ']';
  };
  member("position", state.x);
  out << ',';
  member("orientation", coefficients(state.q));
  const std::pair<const char*, Vec3> rest[] = {{"velocity", now.v},
                                               {"angular_velocity", now.omega},
                                               {"linear_momentum", state.P},
                                               {"angular_momentum", state.L}};
  for (const auto& [name, numbers] : rest) {
    out << ',';
    member(name, numbers);
  }
}

}  // namespace tumble::detail

namespace tumble::output {

TUMBLE_BODY void write_csv(std::ostream& out, const RigidBody<>& body, const Trajectory& trajectory,
                           std::span<const double> times) {
  out << "time," << csv_columns << '\n';
  for (const double t : times) {
    out << detail::shortest(t) << ',';
    detail::write_csv_numbers(out, body, trajectory.at(t));
    out << '\n';
  }
}

TUMBLE_BODY void write_csv(std::ostream& out, const std::vector<RigidBody<>>& bodies,
                           const SceneTrajectory& trajectory, std::span<const double> times) {
  out << "time,body," << csv_columns << '\n';
  for (const double t : times) {
    const std::vector<RigidBodyState<>> states = trajectory.at(t);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      out << detail::shortest(t) << ',' << i << ',';
      detail::write_csv_numbers(out, bodies[i], states[i]);
      out << '\n';
    }
  }
}

TUMBLE_BODY void write_json(std::ostream& out, const RigidBody<>& body,
                            const Trajectory& trajectory, std::span<const double> times) {
  const char* separator = "[\n";
  for (const double t : times) {
    out << separator << "{\"time\":" << detail::shortest(t) << ',';
    detail::write_json_members(out, body, trajectory.at(t));
    out << '}';
    separator = ",\n";
  }
  out << (times.empty() ? "[]\n" : "\n]\n");
}

TUMBLE_BODY void write_json(std::ostream& out, const std::vector<RigidBody<>>& bodies,
                            const SceneTrajectory& trajectory, std::span<const double> times) {
  const char* separator = "[\n";
  for (const double t : times) {
    const std::vector<RigidBodyState<>> states = trajectory.at(t);
    out << separator << "{\"time\":" << detail::shortest(t) << ",\"bodies\":[";
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      out << (i == 0 ? "{" : ",{");
      detail::write_json_members(out, bodies[i], states[i]);
      out << '}';
    }
    out << "]}";
    separator = ",\n";
  }
  out << (times.empty() ? "[]\n" : "\n]\n");
}

}  // namespace tumble::output
