#pragma once
/// @file
/// States at asked times, as text for other programs: CSV, and JSON (RFC 8259). A number has
/// as few digits as give a reader the same double back; a zero has no sign.

#include <ostream>
#include <span>
#include <vector>

#include "tumble/core/shortest.hpp"
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

/// The numbers one after the other, with commas between.
template <class Numbers>
void write_numbers(std::ostream& out, const Numbers& numbers) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i)
    out << (i == 0 ? "" : ",") << shortest(numbers[i]);
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
