#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace momentum_chapter {

using tumble::support::Table;

// ── angular.cpp ──

/// The masses move into the page (crosses) and out of it (dots).
std::string askew_figure();
/// How far L and ω can be apart.
Table apart_table();
/// The angular momentum of bodies: the orbital part and the spin part.
Table split_table();

// ── by_hand.cpp ──

/// A force at two points of its line: the torque is the same.
Table lever_table();
/// A kick of 2 N s a sixth of the plank's length off its centre.
Table sixth_table();
/// Two masses on a leaning rod: tensor, L, torque of the bearings.
Table askew_table();
/// The same rod, spun about a principal axis, and about itself.
Table along_table();

// ── cost.cpp ──

/// From L to ω: operations.
Table counts_table();
/// From L to ω: times.
Table times_table();

// ── diagrams.cpp ──

/// A point of a racket in the world's axes and in its own.
std::string frames_figure();
/// Arm, force and torque.
std::string torque_figure();

// ── far.cpp ──

/// How far a double is from the next, at several distances from the origin.
Table gaps_table();
/// Error of a torque against the distance from the origin.
std::string far_figure();

// ── flight.cpp ──

/// A racket thrown to the right. The end of its handle loops.
std::string flight_figure();
/// How far the centre of mass and the middle of the bounding box are apart.
Table centres_table();

// ── frames.cpp ──

/// A body that has turned, and the velocity of a point of it with ω × r, where r has been
/// turned with the body or forgotten to be.
Table forgotten_table();
/// A wheel of a train at 300 km/h.
Table wheel_table();
/// A wheel of radius 1 with a flange of 0.2, its velocities, and the way of a point of the
/// flange.
std::string wheel_figure();

// ── hard_cases.cpp ──

/// Error of ω against the ratio of the moments.
std::string needle_figure();
/// A spinning satellite with a nozzle.
Table nozzle_table();
/// A plank that hangs from a spring.
Table arm_table();
/// Forces that cancel.
Table cancel_table();

// ── push.cpp ──

/// A kick of 200 N for 10 ms against a plank of 2 kg and 1 m.
Table push_table();
/// Three planks, seen from above, at equal times after the kick.
std::string push_figure();

// ── stored.cpp ──

/// Ten minutes of a free T-handle.
Table kept_table();
/// The energy after ten minutes and after fifteen, by Euler.
Table longer_table();
/// Ten seconds of a free T-handle, by RK4, averaged over starts.
Table stored_table();
/// Orientation after ten seconds against evaluations, averaged over starts.
std::string stored_figure();

}  // namespace momentum_chapter
