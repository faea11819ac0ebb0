#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace contact_chapter {

using tumble::support::Table;

// ── by_hand.cpp ──

/// A rod that is hit at its end, small enough for paper.
Table by_hand_table();

// ── dropped.cpp ──

/// A ball that is dropped, by steps and by flights.
Table ball_table();
/// Its height over time.
std::string dropped_figure();

// ── friction.cpp ──

/// The rod that jumps up, by three laws.
Table rod_table();
/// A thousand impacts, by three laws.
Table laws_table();
/// At which angles a slender rod jams.
Table painleve_table();

// ── sweep.cpp ──

/// How many pairs sort and sweep compares.
Table sweep_table();

// ── touching.cpp ──

/// A bullet and a thin plate.
Table tunnel_table();

// ── zeno.cpp ──

/// When a ball bounces, and how high.
Table zeno_table();

}  // namespace contact_chapter
