#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace rotation_matrices_chapter {

using tumble::support::Table;

// ── pictures.cpp ──

/// A mug after two quarter turns, in both orders.
std::string order_figure();
/// A mug turned by Euler steps that nobody repairs.
std::string sheared_figure();

// ── arrows.cpp ──

/// The columns of a rotation matrix, and the same three as arrows of a mug.
std::string columns_figure();
/// The velocity of a point of a turning body.
std::string cross_figure();
/// The same with numbers.
Table turning_point_table();

// ── angles.cpp ──

/// The same three angles in different orders.
Table order_table();
/// The axes of three turns, far from gimbal lock and in it.
std::string gimbal_figure();
/// What a turn by 1° does to the three angles, the nearer to gimbal lock the more.
Table lock_table();

// ── drift.cpp ──

/// A steady turn by steps of three methods.
Table drift_table();
/// How far its matrix is from a rotation, repaired or not.
std::string drift_figure();
/// The same turn by steps of Euler's method and of the implicit one.
Table backward_table();

// ── by_hand.cpp ──

/// Gram–Schmidt with numbers that fit on paper.
Table gram_schmidt_by_hand_table();
/// The same as a drawing.
std::string gram_schmidt_figure();
/// What happens to a sheared matrix if another column comes first.
Table favourite_table();
/// Newton's iteration on single numbers.
Table newton_table();

// ── singular_values.cpp ──

/// What a matrix makes of a sphere, and what is left of it without the stretches.
std::string ellipsoid_figure();

// ── repair.cpp ──

/// One repair of a drifted matrix.
Table repair_table();
/// What one repair leaves, against what was there.
std::string repair_figure();
/// A minute of midpoint steps, repaired now and then.
Table schedule_table();
/// What one repair takes.
Table times_table();

}  // namespace rotation_matrices_chapter
