#pragma once
/// @file
/// What `./tumble mass` finds out about one file.

#include <limits>
#include <string>
#include <vector>

#include "scenes/commands.hpp"
#include "tumble/mass/parts/mass_properties.hpp"

namespace tumble::scenes {

/// What can be said about a mesh: the numbers only if there is a body.
struct MassAnswer {
  std::string file;
  std::vector<MeshDefect> findings;
  bool usable = true;
  BoundedMassProperties body = {};
  double volume = std::numeric_limits<double>::quiet_NaN();        ///< [m³], of a shell none
  double volume_bound = std::numeric_limits<double>::quiet_NaN();  ///< of its relative error
  double area = std::numeric_limits<double>::quiet_NaN();          ///< [m²], of a shell
  double density = 1;  ///< [kg/m³], or [kg/m²] of a shell; of a weighed body what it comes to
  std::vector<parts::PartMass> parts = {};  ///< if they have densities of their own
};

/// The volume of a part [m³].
inline double volume_of(const parts::PartMass& part) { return part.mass / part.density; }

/// Reads a file and answers.
/// @throws std::invalid_argument if it cannot be read, or a number that was given means nothing
MassAnswer mass_answer(const MassCommand& command, const std::string& file);

/// The mesh files that are meant: those given, and all in given folders, by name.
/// @throws std::invalid_argument if a folder has none
std::vector<std::string> mesh_files(const std::vector<std::string>& given);

}  // namespace tumble::scenes
