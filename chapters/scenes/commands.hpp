#pragma once
/// @file
/// `./tumble mass` and `./tumble simulate`: what they are asked, and that they do it.

#include <string>

namespace tumble::scenes {

struct MassCommand {
  std::string file, accuracy = "tight";
  double density = 1;  ///< [kg/m³]
  bool json = false, accept = false;
};

struct SimulateCommand {
  std::string file, csv, svg;
  bool json = false;
};

/// Prints the mass properties of a mesh file (OBJ, STL or PLY) and what was found about it.
/// @return 0, or 1 if the mesh is not the boundary of a body (with `accept`: only if nothing could
///         be integrated over)
/// @throws std::invalid_argument if the file cannot be read
int run(const MassCommand& command);

/// Simulates a scene file and prints the motion and what it took.
/// @return 0, or 1 if a tolerance was not reached
/// @throws std::invalid_argument if the file says something that is not a scene
/// @throws std::runtime_error if a motion cannot be followed to its end
int run(const SimulateCommand& command);

}  // namespace tumble::scenes
