#pragma once
/// @file
/// The T-handle that turns over in orbit: a stem along x in the middle of a bar along y.
///
/// Its moment about the stem is the intermediate one, and so spinning about the stem is not stable.

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::objects {

/// A T-handle 12 cm wide, about 430 r² triangles. @param r resolution, from 1
PolygonMesh t_handle(int r);

}  // namespace tumble::objects

#ifndef TUMBLE_COMPILED
#include "objects/t_handle.inl"
#endif
