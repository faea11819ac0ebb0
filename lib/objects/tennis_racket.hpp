#pragma once
/// @file
/// A wooden tennis racket: its handle along −x, its face in the xy plane.
///
/// The strings are bars of their own that end a millimetre before the frame: nothing touches.

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::objects {

inline constexpr double head_length = 0.165, head_width = 0.130;  ///< half axes of the frame [m]
inline constexpr double frame_half_width = 0.0065, frame_half_height = 0.0105;

/// A racket 69 cm long, about 1,050 r² triangles and 32 strings. @param r resolution, from 1
PolygonMesh tennis_racket(int r);

}  // namespace tumble::objects

#ifndef TUMBLE_COMPILED
#include "objects/tennis_racket.inl"
#endif
