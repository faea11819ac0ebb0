#pragma once
/// @file
/// Writes positions and faces as a Wavefront OBJ file, so that reading it gives the same bits.

#include <locale>
#include <ostream>
#include <string>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

/// Writes a mesh, with the 17 digits that tell any two doubles apart.
/// @param mesh indices in range, positions finite
void write_obj(std::ostream& out, const PolygonMesh& mesh);

// wasi-libc++ has no file streams.
#ifndef __wasi__

/// Writes a mesh to a file.
/// @throws std::runtime_error when it cannot be written
void write_obj(const std::string& path, const PolygonMesh& mesh);

#endif

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/write_obj.inl"
#endif
