#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace quaternions_chapter {

using tumble::support::Table;

// ── arrows.cpp ──

/// What both factors of q p q⁻¹ do to a point.
std::string turn_figure();
/// The arc from one quaternion to another, and the parts of a point on it.
std::string arc_figure();

// ── by_hand.cpp ──

/// The product of two quarter turns.
Table product_by_hand_table();
/// What that product does to some points.
Table point_by_hand_table();
/// What is left halfway if nine numbers are mixed, and if four are.
Table halfway_table();
/// How long RK4 takes to make a quaternion shorter by a hundredth.
Table shrink_table();

// ── cost.cpp ──

/// Error after ten seconds of a top against the multiplications spent.
std::string work_figure();
/// What an orientation error costs.
Table reach_table();
/// What the other operations take.
Table times_table();

// ── counts.cpp ──

/// What the arithmetic of an orientation costs.
Table counts_table();

// ── digits.cpp ──

/// The angle of a small turn.
Table small_angles_table();
/// A quarter of the way between two that are close.
Table near_table();

// ── drift.cpp ──

/// A steady turn of 2 rad/s in steps of 1/60 s.
Table drift_table();
/// How far from a rotation nine numbers and four numbers get, if nobody repairs them.
std::string drift_figure();
/// One step of a turn that is large for it.
Table big_steps_table();

// ── pace.cpp ──

/// Equal parts of the chord, seen from the middle, are unequal parts of the arc.
std::string chord_figure();
/// How fast the plane turns on each way of 150°. Only slerp keeps its pace.
std::string pace_figure();
/// How uneven the pace of a mixture is, and how far it is from where slerp is, at worst.
Table pace_table();

// ── turns.cpp ──

/// Some turns and their quaternions.
Table turns_table();
/// Two quarter turns in both orders.
Table order_table();
/// The plane at eight moments of a turn about the vertical that goes round twice; the
/// quaternion goes round once.
std::string circle_figure();
/// A turn of 60° by a quaternion that is too long.
Table length_table();
/// Half as far from a half turn, the formula with one case errs four times as much.
std::string half_turn_figure();

// ── ways.cpp ──

/// Five ways of 150°.
Table ways_table();
/// Nine mixed numbers crush the plane to a fifteenth of its volume, three mixed angles twist it
/// about.
std::string between_figure();

}  // namespace quaternions_chapter
