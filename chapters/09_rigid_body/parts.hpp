#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace rigid_body_chapter {

using tumble::support::Table;

// ── by_hand.cpp ──

/// What follows from a state with numbers that fit on paper.
Table derived_by_hand_table();
/// One step of Euler's method from that state.
Table step_by_hand_table();
/// The length of its quaternion after that step, and the rate of a quaternion twice as long.
Table length_by_hand_table();
/// The gyroscopic term in that state.
Table term_by_hand_table();

// ── cost.cpp ──

/// One evaluation: operations.
Table counts_table();
/// One evaluation: times.
Table times_table();
/// The mug's orientation after half a second against evaluations.
std::string work_figure();
/// What simulate() says, and what is true.
Table stated_table();
/// Half a second of the mug: time to reach an error.
Table race_table();

// ── diagrams.cpp ──

/// The way of the numbers through dydt.
std::string machine_figure();
/// A point of the mug from the world's origin and from its centre of mass.
std::string frames_figure();
/// L, seen from the world and from the body.
std::string seen_figure();

// ── frames.cpp ──

/// How far ω is off, by the size of the true one, for a body that has turned.
Table frames_table();
/// The same after a half turn about a principal axis.
Table half_turn_table();

// ── gyroscopic.cpp ──

/// The free handle by right laws and by wrong ones.
Table laws_table();
/// The handle's spin about its middle axis. Without the gyroscopic term it never turns over.
std::string laws_figure();

// ── hard_cases.cpp ──

/// A thousand seconds of the free handle.
Table thousand_table();
/// A force that begins within a step.
Table begins_table();
/// Twenty turns by long steps of RK4.
Table fast_table();
/// A mug in honey.
Table honey_table();

// ── length.cpp ──

/// When q is given the length 1.
Table length_table();
/// A force that takes q at its word.
Table trusting_table();

// ── mug.cpp ──

/// The energy of a mug on a spring.
Table ledger_table();
/// The mug's first two seconds.
std::string mug_figure();

// ── plain_arrays.cpp ──

/// The mug by a solver that knows plain arrays only.
Table arrays_table();

// ── routes.cpp ──

/// The orientation by nine numbers and by four, with the same steps.
Table matrix_table();
/// A tensor from points, and from faces.
Table sampled_table();

// ── steps.cpp ──

/// Three seconds of the mug on its spring.
Table steps_table();
/// Forces asked four times a step, and once.
Table stale_table();
/// Ten seconds of the free handle, by RK4.
Table free_table();
/// The largest error of the energy so far.
std::string energy_figure();

// ── tumbling.cpp ──

/// The nut photographed by flashes that follow each other as the turns do, and its spin.
std::string nut_figure();
/// The nut, moving: once for each turn.
std::string slow_motion_figure();
/// ω along the three axes of the nut, over some flips.
std::string spin_figure();
/// The tip of L in the body, on its sphere. Curves go round the least and the largest axis.
std::string polhode_figure();
/// How often a body turns over.
Table flips_table();
/// The same for a handle that is aimed to a billionth of a radian.
Table aimed_table();

}  // namespace rigid_body_chapter
