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
  std::string refusal = {};   ///< why we could not answer: the file could not be read
  std::string no_block = {};  ///< why there is no --urdf, --sdf or --mjcf
  bool usable = true;
  int welded = 0;  ///< how many vertices were taken for others at the same position
  BoundedMassProperties body = {};
  double volume = std::numeric_limits<double>::quiet_NaN();        ///< [m³], of a shell none
  double volume_bound = std::numeric_limits<double>::quiet_NaN();  ///< of its relative error
  double area = std::numeric_limits<double>::quiet_NaN();          ///< [m²], of a shell
  double density = 1;  ///< [kg/m³], or [kg/m²] of a shell; of a weighed body what it comes to
  std::vector<parts::PartMass> parts = {};  ///< if they have densities of their own
};

/// The volume of a part [m³].
inline double volume_of(const parts::PartMass& part) { return part.mass / part.density; }

/// @throws std::invalid_argument if a number that was given means nothing, or numbers contradict
///         each other
void require_meaning(const MassCommand& command);

/// Reads a file and answers.
/// @param command one that has a meaning
/// @throws std::invalid_argument if the file cannot be read, or a double can't hold the answer
MassAnswer mass_answer(const MassCommand& command, const std::string& file);

/// The same for one of several files: what one of them has wrong does not cost the others theirs.
MassAnswer answer_or_refusal(const MassCommand& command, const std::string& file);

}  // namespace tumble::scenes
