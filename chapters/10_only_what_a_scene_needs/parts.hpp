#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace scene_chapter {

using tumble::support::Table;

// ── by_hand.cpp ──

/// A free symmetric top, small enough for paper.
Table top_by_hand_table();
/// Five energies and the line that fits them, small enough for paper.
Table energy_by_hand_table();

// ── cost.cpp ──

/// Evaluations that an error needs.
Table work_table();

// ── crowd.cpp ──

/// Many bodies at once: what each takes.
Table crowd_table();

// ── diagrams.cpp ──

/// Which model a scene needs.
std::string tree_figure();

// ── elliptic.cpp ──

/// The elliptic sine over one period.
std::string sn_figure();
/// Ways of L on its sphere with a dot for each 48th of a round.
std::string clock_figure();
/// A free body, far in the future.
Table future_table();
/// The error of a free body against time.
std::string future_figure();
/// What the start decides.
Table condition_table();

// ── energy.cpp ──

/// The energy of the free handle.
Table free_energy_table();
/// The energy of a nodding top.
Table drift_table();
/// A trend from two states, and from all.
Table ends_table();
/// The energy of a nodding top against time, by each method.
std::string drift_figure();
/// A force that looks at the spin.
Table spoiled_table();
/// The energy, if the length of the steps changes.
Table changing_table();

// ── equal.cpp ──

/// How wrong a simpler body turns.
Table equal_table();
/// The wing nut taken for a top.
Table nut_table();

// ── free_top.cpp ──

/// Wobbles in a turn.
Table wobble_table();
/// Two turns, on the right side and on the wrong one.
Table sides_table();
/// ω goes round a cone about L in the world, and round one about n in the body.
std::string cones_figure();

// ── hard_cases.cpp ──

/// A thousand seconds next to the separatrix.
Table hard_flips_table();
/// Hard cases, one by one.
Table hard_cases_table();
/// Moments that no body has, and what the library says of them.
Table hard_refused_table();
/// Tops that sleep, and tops that fall.
Table hard_tops_table();
/// What a million steps leave of the digits.
Table hard_million_table();
/// A minute by RK4 in float and in double.
Table hard_float_table();

// ── heavy_top.cpp ──

/// The tip of a heavy top on its sphere, once round the vertical.
std::string tip_figure();
/// How far a top leans.
Table sleep_table();
/// A top that slows down.
Table event_table();
/// How far the axis of that top leans, against time.
std::string sleep_figure();
/// A lopsided body by Taylor series: order and error for each tolerance.
Table series_table();

// ── ladder.cpp ──

/// What bodies are.
Table chosen_table();
/// What model_of_moments() says, and why.
Table why_table();
/// What simulate() chooses for a scene, and what the full body needs for the same.
Table ladder_table();
/// What a rung costs.
Table rungs_table();
/// What forces of zero cost.
Table absent_table();
// ── spinning_ball.cpp ──

/// A golf ball with back-spin as a particle, as a spinning ball and as a full body.
Table spin_table();

// ── stated.cpp ──

/// What simulate() says, and what is true.
Table stated_table();
/// Tolerances that no method reaches, and what simulate() says then.
Table unreachable_table();

}  // namespace scene_chapter
