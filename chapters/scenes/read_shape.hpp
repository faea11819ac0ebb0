#pragma once
/// @file
/// The shape of a body in a scene file: what it weighs, what it collides as, what it looks like.

#include <filesystem>
#include <variant>

#include "scenes/scene.hpp"
#include "support/place.hpp"
#include "tumble/mass.hpp"

namespace tumble::scenes {

/// A shape in its own coordinates.
struct ReadShape {
  std::variant<Ball, Box, Ellipsoid, Cylinder, Cone, Capsule, PolygonMesh> solid;
  MassProperties unit;  ///< at 1 kg/m³, or with the densities of its parts
};

/// The file that a mesh names: beside the scene's.
std::filesystem::path mesh_path(const support::Place& mesh, const std::filesystem::path& folder);

/// @param densities of the parts of a mesh; empty if the shape has the same density everywhere
/// @throws std::invalid_argument that says where in the file, and what
ReadShape read_shape(const support::Place& shape, const std::filesystem::path& folder,
                     const parts::Densities& densities);

/// What collides of it, and its picture, around its centre of mass.
/// @throws std::invalid_argument if its hull has no volume
BodyShape body_shape(const ReadShape& shape);

}  // namespace tumble::scenes
