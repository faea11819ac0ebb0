#pragma once
/// @file
/// A mug: its axis along z, its handle towards x.

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::objects {

/// A mug 9.6 cm high with walls of 4 mm, about 1,300 r² triangles. @param r resolution, from 1
PolygonMesh mug(int r);

}  // namespace tumble::objects

#ifndef TUMBLE_COMPILED
#include "objects/mug.inl"
#endif
