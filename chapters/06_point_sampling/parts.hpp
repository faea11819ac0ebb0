#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace point_sampling_chapter {

using tumble::support::Table;

// ── axes.cpp ──

/// A racket from above, and two axes to swing it about.
std::string swing_figure();
/// How far from its centre of mass a racket is twice as hard to swing.
Table twice_table();
/// How hard a racket is to swing about an axis across its handle, in the plane of the strings.
Table racket_table();
/// Error of the inertia of 300 points, moved without being rounded.
std::string far_figure();

// ── by_hand.cpp ──

/// One, two and four kilograms, and their products of inertia.
Table kilograms_table();
/// The same objects by coarser and finer meshes.
Table meshes_table();

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
/// The same on 31³ points.
Table edge_31_table();
/// The cube from above: where columns of points have gone.
std::string edge_figure();

// ── grid.cpp ──

/// A box that its cells fill exactly: what is missing is the cells' own inertia.
Table cells_table();
/// The same with more cells.
Table finer_table();
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

// ── rays.cpp ──

/// Rays to the right through the wall of a mug.
std::string rays_figure();
/// A triangle from above, and the small triangles that a point makes with its edges.
std::string sides_figure();

// ── squares.cpp ──

/// 256 points and a shape to be weighed. Random points leave holes and crowd elsewhere.
std::string squares_figure();
/// Cells that the outline cuts.
std::string cells_figure();

}  // namespace point_sampling_chapter
