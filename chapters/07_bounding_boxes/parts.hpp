#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace bounding_boxes_chapter {

using tumble::support::Table;

// ── by_hand.cpp ──

/// The box of three points, and of many more in one place.
Table corners_table();
/// Eight points whose principal box is larger than the one along the axes.
Table diamond_table();

// ── cost.cpp ──

/// What a box takes, and what the exact sum does.
Table times_table();

// ── cube.cpp ──

/// A cube with eight vertices and with nine, and their principal boxes.
std::string cube_figure();

// ── equivalent.cpp ──

/// The box that turns like the object.
Table equivalent_table();
/// The box around an object, and the box that turns like it.
std::string equivalent_figure();

// ── errors.cpp ──

/// Inertia of a box for that of an object: relative error.
Table errors_table();
/// The inertia of a cube around a hollow ball, to the ball's.
Table hollow_table();
/// Body against box, by how full the box is.
std::string between_figure();

// ── far.cpp ──

/// Error of a racket's box, moved away from the origin without being rounded.
std::string far_figure();

// ── flight.cpp ──

/// Orientation off after one second of 10 rad/s.
Table flight_table();
/// Error of the orientation against the difference of the tensors, for all objects and many
/// boxes.
std::string rule_figure();
/// Which axis is the easy one.
Table moments_table();
/// A mug spun about its easiest axis, 3 turns per second.
Table mug_table();
/// One throw, computed twice. The arrow, painted on the mug, is the axis of its spin.
std::string spin_figure();
/// The same, moving, four times slower than it is.
std::string slow_motion_figure();

// ── hard_cases.cpp ──

/// Bodies that are bad for boxes.
Table hard_table();

// ── sides.cpp ──

/// A racket from above. Its points scatter most along the handle and least across it.
std::string lies_figure();
/// From the side, the mug's handle tilts its principal box.
std::string sides_figure();
/// Volume of the mug's box against its turn. Upright it stands in a shallow valley.
std::string valley_figure();
/// What the descent finds from where it starts.
Table descent_table();

}  // namespace bounding_boxes_chapter
