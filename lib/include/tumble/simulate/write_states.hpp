#pragma once
/// @file
/// States at asked times, as text for other programs: CSV, and JSON (RFC 8259). All numbers are
/// written with 17 digits, from which a reader gets the same doubles back.

#include <iomanip>
#include <limits>
#include <ostream>
#include <span>
#include <vector>

#include "tumble/body/derived.hpp"
#include "tumble/simulate/simulate_bodies.hpp"

namespace tumble::output {

/// @addtogroup simulate
/// @{

/// The names of the numbers that follow the time (and the body) in a line, comma-separated: SI
/// units, world coordinates, about the centre of mass.
inline constexpr const char* csv_columns =
    "x,y,z,qw,qx,qy,qz,vx,vy,vz,omega_x,omega_y,omega_z,Px,Py,Pz,Lx,Ly,Lz";

/// @}

}  // namespace tumble::output

namespace tumble::detail {

/// Writes with all digits; the stream is as before at the end.
class AllDigits {
 public:
  explicit AllDigits(std::ostream& out) : out_(out), flags_(out.flags()), digits_(out.precision()) {
    out << std::defaultfloat << std::setprecision(std::numeric_limits<double>::max_digits10);
  }
  ~AllDigits() {
    out_.flags(flags_);
    out_.precision(digits_);
  }
  AllDigits(const AllDigits&) = delete;
  AllDigits& operator=(const AllDigits&) = delete;

 private:
  std::ostream& out_;
  std::ios_base::fmtflags flags_;
  std::streamsize digits_;
};

/// The numbers one after the other, with commas between.
template <class Numbers>
void write_numbers(std::ostream& out, const Numbers& numbers) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) out << (i == 0 ? "" : ",") << numbers[i];
}

/// The numbers of output::csv_columns.
inline void write_csv_numbers(std::ostream& out, const RigidBody<>& body,
                              const RigidBodyState<>& state) {
  const Derived<> now = derived(body, state);
  Eigen::Matrix<double, 19, 1> numbers;
  numbers << state.x, coefficients(state.q), now.v, now.omega, state.P, state.L;
  write_numbers(out, numbers);
}

/// "position":[…],"orientation":[w,x,y,z], … with the names that ./tumble simulate --json uses.
inline void write_json_members(std::ostream& out, const RigidBody<>& body,
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

/// @addtogroup simulate
/// @{

/// A line of names, then one for each time.
/// @param times [s] within the trajectory
/// @throws std::invalid_argument for a time that is not
inline void write_csv(std::ostream& out, const RigidBody<>& body, const Trajectory& trajectory,
                      std::span<const double> times) {
  const detail::AllDigits all(out);
  out << "time," << csv_columns << '\n';
  for (const double t : times) {
    out << t << ',';
    detail::write_csv_numbers(out, body, trajectory.at(t));
    out << '\n';
  }
}

/// The same of several bodies: one line for each time and body, with the body's number from 0.
inline void write_csv(std::ostream& out, const std::vector<RigidBody<>>& bodies,
                      const SceneTrajectory& trajectory, std::span<const double> times) {
  const detail::AllDigits all(out);
  out << "time,body," << csv_columns << '\n';
  for (const double t : times) {
    const std::vector<RigidBodyState<>> states = trajectory.at(t);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      out << t << ',' << i << ',';
      detail::write_csv_numbers(out, bodies[i], states[i]);
      out << '\n';
    }
  }
}

/// A list of objects, one for each time: {"time", "position", "orientation" as [w, x, y, z],
/// "velocity", "angular_velocity", "linear_momentum", "angular_momentum"}.
/// @param times [s] within the trajectory
/// @throws std::invalid_argument for a time that is not
inline void write_json(std::ostream& out, const RigidBody<>& body, const Trajectory& trajectory,
                       std::span<const double> times) {
  const detail::AllDigits all(out);
  const char* separator = "[\n";
  for (const double t : times) {
    out << separator << "{\"time\":" << t << ',';
    detail::write_json_members(out, body, trajectory.at(t));
    out << '}';
    separator = ",\n";
  }
  out << (times.empty() ? "[]\n" : "\n]\n");
}

/// The same of several bodies: {"time", "bodies": a list of objects}.
inline void write_json(std::ostream& out, const std::vector<RigidBody<>>& bodies,
                       const SceneTrajectory& trajectory, std::span<const double> times) {
  const detail::AllDigits all(out);
  const char* separator = "[\n";
  for (const double t : times) {
    const std::vector<RigidBodyState<>> states = trajectory.at(t);
    out << separator << "{\"time\":" << t << ",\"bodies\":[";
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

/// @}

}  // namespace tumble::output
