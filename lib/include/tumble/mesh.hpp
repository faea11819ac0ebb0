#pragma once
/// @file
/// Everything about meshes.

/// @defgroup mesh Meshes
/// Everything about meshes.

#include "tumble/mesh/diagnose.hpp"
#include "tumble/mesh/mesh_solid.hpp"
#include "tumble/mesh/parse_mesh.hpp"
#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/mesh/read_mesh.hpp"
#include "tumble/mesh/weld.hpp"
#include "tumble/mesh/write_obj.hpp"

/// Where a surface passes through itself.
/// @ingroup mesh
namespace tumble::crossings {}
