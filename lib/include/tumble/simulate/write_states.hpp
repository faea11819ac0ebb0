#pragma once
/// @file
/// States at asked times, as text for other programs: CSV, and JSON (RFC 8259). All numbers are
/// written with 17 digits, from which a reader gets the same doubles back.

#include <iomanip>
#include <limits>
#include <ostream>
#include <span>
#include <vector>

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
void write_csv_numbers(std::ostream& out, const RigidBody<>& body, const RigidBodyState<>& state);

/// "position":[…],"orientation":[w,x,y,z], … with the names that ./tumble simulate --json uses.
void write_json_members(std::ostream& out, const RigidBody<>& body, const RigidBodyState<>& state);

}  // namespace tumble::detail

namespace tumble::output {

/// @addtogroup simulate
/// @{

/// A line of names, then one for each time.
/// @param times [s] within the trajectory
/// @throws std::invalid_argument for a time that is not
void write_csv(std::ostream& out, const RigidBody<>& body, const Trajectory& trajectory,
               std::span<const double> times);

/// The same of several bodies: one line for each time and body, with the body's number from 0.
void write_csv(std::ostream& out, const std::vector<RigidBody<>>& bodies,
               const SceneTrajectory& trajectory, std::span<const double> times);

/// A list of objects, one for each time: {"time", "position", "orientation" as [w, x, y, z],
/// "velocity", "angular_velocity", "linear_momentum", "angular_momentum"}.
/// @param times [s] within the trajectory
/// @throws std::invalid_argument for a time that is not
void write_json(std::ostream& out, const RigidBody<>& body, const Trajectory& trajectory,
                std::span<const double> times);

/// The same of several bodies: {"time", "bodies": a list of objects}.
void write_json(std::ostream& out, const std::vector<RigidBody<>>& bodies,
                const SceneTrajectory& trajectory, std::span<const double> times);

/// @}

}  // namespace tumble::output

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/write_states.inl"
#endif
