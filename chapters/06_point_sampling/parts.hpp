#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace point_sampling_chapter {

using tumble::support::Table;

// ── axes.cpp ──

/// How hard a racket is to swing about an axis across its handle, in the plane of the strings.
Table racket_table();
/// Error of the inertia of 300 points, moved without being rounded.
std::string far_figure();

// ── cloud.cpp ──

/// Points thrown at the mug's box.
std::string cloud_figure();

// ── columns.cpp ──

/// Forty columns through the mug, seen from the side.
std::string columns_figure();

// ── cost.cpp ──

/// Is a point inside?
Table inside_table();
/// The inertia of a mug: what each way takes.
Table times_table();

// ── csg.cpp ──

/// The centre of mass of a die with drilled pips.
Table die_table();
/// A die and a mug that has been cut open.
std::string csg_figure();

// ── edge.cpp ──

/// A box on a grid of 32³ points.
Table edge_table();
/// The cube from above: where columns of points have gone.
std::string edge_figure();

// ── grid.cpp ──

/// A box that its cells fill exactly: what is missing is the cells' own inertia.
Table cells_table();
/// How much of their boxes the objects fill, and what that means for random points.
Table fill_table();
/// Flat faces along the planes of the grid.
Table loose_table();

// ── orders.cpp ──

/// The error of a mug's inertia.
Table orders_table();
/// The error of the mug's inertia against the number of points or columns.
std::string orders_figure();
/// The standard error of a mug's mass.
Table honest_table();

// ── squares.cpp ──

/// 256 points and a shape to be weighed. Random points leave holes and crowd elsewhere.
std::string squares_figure();
/// Cells that the outline cuts.
std::string cells_figure();

}  // namespace point_sampling_chapter
