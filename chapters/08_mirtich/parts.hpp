#pragma once
/// @file
/// The tables and figures of the chapter's program, by the part that makes them.

#include <string>

#include "support/table.hpp"

namespace mirtich_chapter {

using tumble::support::Table;

// ── bad_meshes.cpp ──

/// What is found in spoiled cubes.
Table findings_table();
/// What integrals make of spoiled cubes.
Table accept_table();
/// A cube with one corner pulled by 0.2 m.
Table nonplanar_table();
/// A cube with a spike through its top.
Table missed_table();
/// Surfaces spread out over random places.
Table balance_table();
/// An octahedron whose vertices are at random places.
std::string places_figure();
/// The depth along a line through a body with a part inside.
std::string depth_figure();

// ── by_hand.cpp ──

/// The corner of a cube, by all three steps.
Table corner_table();
/// Its mass, centre and inertia.
Table corner_body_table();
/// Once around a square of side 4 with a dent: what each edge contributes.
Table walk_table();
/// The same for ∬ β.
Table walk_beta_table();

// ── cost.cpp ──

/// What a triangle costs, in operations.
Table counts_table();
/// Relative errors of the inertia.
Table errors_table();
/// How far a mesh of n triangles is from the torus that it stands for.
Table mesh_table();
/// What each way takes.
Table times_table();
/// Cubes that are very small or very large, and what the library says of them.
Table sizes_table();

// ── drawings.cpp ──

/// A face and its shadow, in space and from the side.
std::string shadow_figure();
/// Once around a square with a dent.
std::string walk_figure();

// ── far.cpp ──

/// A mug far from the origin, by shadows: relative errors.
Table far_by_shadows_table();
/// A mug far from the origin: relative errors.
Table far_table();
/// The centre of mass of a mug far from the origin.
Table rest_table();
/// Errors of a mug ever farther away.
std::string far_figure();

// ── gem.cpp ──

/// What the faces of a gem contribute to its volume.
Table shadows_table();
/// The gem's volume if some of its faces are turned round.
Table turned_table();
/// The gem, of diamond.
Table gem_table();
/// A gem over a floor.
std::string gem_figure();

// ── levels.cpp ──

/// A body cut into rods along x. Each rod knows only its ends.
std::string rods_figure();
/// Relative errors of shadows along z, the worst of 50 faces.
Table axis_table();

// ── pairs.cpp ──

/// Sums and products with what rounding loses of them.
Table pairs_table();

// ── tetrahedra.cpp ──

/// The corner of a cube as signed tetrahedra, with different apexes.
Table apex_table();
/// The same with the apex in the body.
Table apex_inside_table();

// ── thin.cpp ──

/// Relative errors of the mass, and their bounds.
Table thin_table();
/// Errors of the mass of thin bodies, and their bounds.
std::string thin_figure();

}  // namespace mirtich_chapter
