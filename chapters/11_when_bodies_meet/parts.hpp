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

// ── bounces.cpp ──

/// A ball with back-spin, from contact to contact.
std::string bounces_figure();

// ── diagrams.cpp ──

/// What impulses at the end of a rod do to its velocity.
std::string answers_figure();
/// The rod that jumps up, by two laws.
std::string rod_figure();

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
/// The tip's velocity while the normal impulse grows.
std::string slip_figure();

// ── hard_cases.cpp ──

/// Contacts that break simulators, one by one.
Table hard_cases_table();

// ── magnify.cpp ──

/// A die, and one that starts a nanometre higher.
Table magnify_table();

// ── plane.cpp ──

/// Two boxes and the plane between them.
std::string plane_figure();

// ── sweep.cpp ──

/// How many pairs sort and sweep compares.
Table sweep_table();

// ── touching.cpp ──

/// A bullet and a thin plate.
Table tunnel_table();
/// Conservative advancement of a rod that turns and sinks.
std::string staircase_figure();

// ── zeno.cpp ──

/// When a ball bounces, and how high.
Table zeno_table();
/// The height of such a ball, and how high it will rise.
std::string zeno_figure();

}  // namespace contact_chapter
