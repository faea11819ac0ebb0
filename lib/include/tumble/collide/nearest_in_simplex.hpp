#pragma once
/// @file
/// The point of a simplex that is nearest to the origin: every vertex, edge, face and the inside is
/// tried, and what holds after rounding is compared.
///
/// That is dearer than a walk through the regions, and cannot lose its way in one that is flat.
/// Source of the weights: Montanari, Petrinic & Barbieri, "Improving the GJK algorithm for faster
/// and more reliable distance queries", ACM TOG 36(3) (2017), §4, the signed volumes.

#include <optional>

#include "tumble/collide/difference.hpp"

namespace tumble::collide::detail {

/// The corners `mask` of a simplex.
Simplex part_of(const Simplex& all, int mask);

/// The corners `mask` of a simplex, with the weights of the point of the plane through them that is
/// nearest to the origin; nothing if that point lies outside of them.
std::optional<Simplex> nearest_inside(const Simplex& all, int mask);

/// The part of a simplex, and the weights of its corners, whose point is nearest to the origin.
/// @param rounding of a place: a tetrahedron counts only if its weights lead to the origin, which
///                 those of a flat one do not
Simplex nearest_in(const Simplex& all, double rounding);

/// The direction that is perpendicular to a point, an edge or a face, to rounding, and nearest to a
/// given one.
Vec3 direction_to(const Simplex& part, const Vec3& towards);

}  // namespace tumble::collide::detail

#ifndef TUMBLE_COMPILED
#include "tumble/collide/nearest_in_simplex.inl"
#endif
