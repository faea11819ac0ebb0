#pragma once
/// @file
/// A wing nut of size M8: its bore along z (plain: the thread is left out), its wings along x.

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::objects {

/// A wing nut 4.8 cm wide, about 500 r² triangles. @param r resolution, from 1
PolygonMesh wing_nut(int r);

}  // namespace tumble::objects

#ifndef TUMBLE_COMPILED
#include "objects/wing_nut.inl"
#endif
