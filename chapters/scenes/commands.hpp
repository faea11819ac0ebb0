#pragma once
/// @file
/// `./tumble mass` and `./tumble simulate`: what they are asked, and that they do it.

#include <optional>
#include <string>
#include <vector>

namespace tumble::scenes {

struct MassCommand {
  std::vector<std::string> files;  ///< or folders with mesh files
  std::string accuracy = "tight", unit = "m";
  std::vector<std::string> density;  ///< "7850" [kg/m³], or "steel=7850" for each part; else 1
  std::optional<double> mass;        ///< as it was weighed [kg]
  std::optional<double> shell;       ///< of a unit of area [kg/m²]: the mass lies in the surface
  std::optional<double> thickness;   ///< the same of a material, `unit`: times its density
  std::vector<double> about;         ///< a point that the inertia is also given about [m]
  double tolerance = 1e-6;  ///< the share of the volume that may count wrongly at a crossing
  std::string block;        ///< "urdf", "sdf" or "mjcf": print only this
  bool json = false, accept = false, thorough = false;

  bool is_shell() const { return shell || thickness; }
};

struct SimulateCommand {
  std::string file, csv, svg, impacts;
  bool json = false;
};

/// Prints the mass properties of mesh files (OBJ, STL or PLY) and what was found about them; of
/// several files a table, one line each.
/// @return 0, or 1 if a mesh is not the boundary of a body (with `accept`: only if nothing could be
///         integrated over), or 2 if one of several files cannot be read
/// @throws std::invalid_argument if the only file cannot be read
int run(const MassCommand& command);

/// Simulates a scene file and prints the motion and what it took.
/// @return 0, or 1 if a tolerance was not reached, or contact lasted and was not followed
/// @throws std::invalid_argument if the file says something that is not a scene
/// @throws std::runtime_error if a motion cannot be followed to its end
int run(const SimulateCommand& command);

}  // namespace tumble::scenes
