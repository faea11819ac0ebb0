#pragma once
/// @file
/// A spur gear with involute teeth: its bore along z.
///
/// Half the angle of a tooth at radius ρ: ψ(ρ) = π / 2N + inv 20° − inv α, cos α = ρ_base / ρ,
/// inv α = tan α − α. Source: Norton, "Machine Design" (5th ed.), §12.1–12.2.

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::objects {

inline constexpr int gear_teeth = 18;

/// A gear 6 cm across and 1 cm thick, about 180 r² + 650 r triangles. @param r resolution, from 1
PolygonMesh gear(int r);

}  // namespace tumble::objects

#ifndef TUMBLE_COMPILED
#include "objects/gear.inl"
#endif
