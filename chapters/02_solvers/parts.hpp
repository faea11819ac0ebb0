#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace solvers_chapter {

using tumble::support::Table;

// ── adaptive.cpp ──

/// One revolution of a comet, 75 years.
Table comet_table();
/// Both solvers evaluate the slope 584 times. Equal steps lose the comet at the sun.
std::string comet_figure();
/// The example of the page: four numbers of a satellite, their errors, and the norm.
Table norm_table();
/// Estimated and true errors of steps from the same place, in units of what is allowed.
Table estimate_table();
/// The steps follow the time of a revolution at the comet's distance.
std::string steps_figure();
/// The tolerance that you ask for, and the final error that you get.
Table tolerance_table();

// ── by_hand.cpp ──

/// The factors by which a solver changes its step after several errors.
Table factors_table();
/// A speck in a wind that blows towards a line: the two eigenvalues, and what they forbid.
Table eigenvalues_table();
/// One implicit step by fixed-point iteration and by Newton's method, from the same guess.
Table newton_by_hand_table();

// ── diagrams.cpp ──

/// What is allowed of two errors, before and after the division by their allowances.
std::string norm_figure();
/// A backward step beside Euler's, and the tangents of Newton's method.
std::string implicit_figure();

// ── hard_cases.cpp ──

/// y' = 1 + sin 9t until an engine stops at t = 1/3, then 0. Solved as it is, and in two
/// pieces.
Table kink_table();
/// A pulse of area 1 and a hundredth of a second. Solved in one go, and in two parts.
Table pulse_table();
/// A weight that comes to rest on its spring, until its speed is nothing but rounding.
Table rest_table();
/// Tolerances beyond what a double holds.
Table floor_table();
/// y' = y² from y = 1 in one backward Euler step, whose equation is z = 1 + h z².
Table no_solution_table();
/// The stiff rod by place and by angle.
Table rod_table();
/// Observed orders where the order does not show.
Table unseen_table();

// ── order.cpp ──

/// The order that each method is seen to have.
Table order_table();
/// Error against step.
std::string order_figure();

// ── oscillator.cpp ──

/// The van der Pol oscillator, each dot a step of Radau5.
std::string relaxation_figure();
/// DP 5(4) rides on the limit of stability, 3.3/|λ|, while the oscillator creeps.
std::string ridden_figure();

// ── race.cpp ──

/// Error against evaluations: one revolution of the comet.
std::string comet_work_figure();
/// Error against evaluations: ten seconds of dust.
std::string dust_work_figure();
/// The evaluations of each method's cheapest run for each error; a dash where there is none.
Table reach_table();
/// Times, and how many times that of a method of reference.
Table times_table();
/// The fewest evaluations, in steps of a quarter more, that close an orbit to within 1e-6.
Table eccentricity_table();

// ── stability.cpp ──

/// How far each method is stable.
Table stability_table();
/// By which factor a step of each method changes a damped spring.
Table damped_table();

// ── stiff.cpp ──

/// Ten seconds of a speck of dust, tolerance 1e-6.
Table dust_table();
/// The same speck at other tolerances.
Table indifferent_table();
/// Ten seconds of four specks of dust, each dot a step of an implicit solver.
std::string dust_figure();
/// Ten seconds of dust.
std::string stiffness_figure();
/// The iterations that solve the equation of a backward Euler step, or do not.
Table newton_table();

}  // namespace solvers_chapter
