#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace particles_chapter {

using tumble::support::Table;

// ── balls.cpp ──

/// The same throw of different balls, by RK4 in steps of 1/64 s.
Table balls_table();
/// The same throw of four balls. Without air all would fly along the blue curve.
std::string balls_figure();

// ── by_hand.cpp ──

/// The rates of two particles on a spring, with numbers that fit on paper.
Table dydt_by_hand_table();
/// The four slopes of one step of RK4, for a mass on a spring.
Table slopes_by_hand_table();
/// Where one step of each method leads to.
Table steps_by_hand_table();

// ── conditions.cpp ──

/// The conditions for the order of a method.
Table conditions_table();
/// RK4 as it should be, and with a mistake.
Table mistakes_table();

// ── diagrams.cpp ──

/// Two particles, their numbers in one column, and the rates of these.
std::string column_figure();
/// A solver asks a right-hand side how fast the state changes.
std::string asks_figure();
/// A spring with its vector, its direction and its forces, and what stretches it.
std::string spring_figure();

// ── errors.cpp ──

/// How the error falls with the step.
Table order_table();
/// Error after one revolution. The slopes are the orders 1, 2 and 4.
std::string error_figure();
/// Evaluations of the right-hand side that an error asks for.
Table price_table();

// ── hard_cases.cpp ──

/// The longest step that does not explode.
Table limits_table();
/// Amplitude after one step, which should stay 1. Euler and midpoint make it grow.
std::string growth_figure();
/// A table-tennis ball at 30 m/s, and nothing but drag.
Table smash_table();
/// A spring of 10 N/m and 1 m whose ends meet.
Table same_place_table();

// ── moments.cpp ──

/// A force that depends on time.
Table time_table();
/// A force that jumps.
Table jump_table();

// ── net.cpp ──

/// A net, level at first and held at two corners, falls, swings through below the nails and up
/// behind them.
std::string net_figure();
/// Energy gained by a net of 63 knots in half a second.
Table net_table();

// ── one_step.cpp ──

/// One long step of each method along the grey curve, and the slopes that it looks at.
std::string one_step_figure();

// ── orbit.cpp ──

/// Five revolutions of the same satellite. Euler's steps leave the ellipse.
std::string orbit_figure();
/// Five revolutions of a satellite, 960 evaluations each.
Table orbit_table();
/// From perigee to apogee with ode().
Table ode_table();
/// The error of Euler's method while the step is halved again and again.
Table halved_table();

// ── state.cpp ──

/// Two particles as one column of numbers.
Table state_table();

// ── tangents.cpp ──

/// Steps along the tangent, from curve to curve and out of a circle.
std::string tangents_figure();

// ── times.cpp ──

/// What one step takes.
Table times_table();

}  // namespace particles_chapter
