#pragma once
/// @file
/// The stations of the tour. Each prints a table and leaves its figures and numbers in the folder.

#include <filesystem>
#include <string>
#include <vector>

#include "support/table.hpp"
#include "tumble/body.hpp"
#include "tumble/mass.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::tour {

/// What is taken on the tour: a closed mesh, what it is made of, and what follows from that.
struct Subject {
  std::string name;
  PolygonMesh mesh;
  PolygonMesh drawing;             ///< the same with fewer faces, for pictures
  double density;                  ///< [kg/m³]
  MassProperties exact;            ///< each number the true one, rounded
  std::vector<std::string> notes;  ///< on the mesh
};

/// A tumbling start: the body spins about its middle axis, a little off it, on the side from which
/// it goes away fast.
struct Spin {
  double rate;  ///< [rad/s]
  double tilt;  ///< angle towards the least and away from the largest moment's axis [rad]
};

/// The state of the subject in that spin, its principal axes along the world's: the smallest moment
/// about x, the middle one about y, the largest about z.
RigidBodyState<> spinning(const RigidBody<>& body, const Spin& spin);

/// Where a station leaves what it makes; remembers the names for the end of the tour.
class Output {
 public:
  /// @throws std::runtime_error if the folder cannot be made
  explicit Output(std::filesystem::path folder);

  /// Writes a file into the folder.
  /// @throws std::runtime_error if it cannot be written, saying which
  void write(const std::string& file, const std::string& content);

  /// Prints a heading and a table, and writes the table as `file`.csv.
  void show(const std::string& heading, const support::Table& table, const std::string& file);

  const std::filesystem::path& folder() const { return folder_; }
  const std::vector<std::string>& files() const { return files_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::string> files_;
};

/// Says on stderr what is being done, for steps that take a while.
void progress(const std::string& what);

/// Mass properties by boxes, points and integrals: error against time.
void show_mass(const Subject& subject, Output& output);

/// Drift of a rotation matrix and of a quaternion, without and with repair.
void show_drift(const Subject& subject, Output& output);

/// Error against cost of each ODE method on the tumbling body.
void show_solvers(const Subject& subject, Output& output);

/// The tumbling itself: what turns over and when.
void show_motion(const Subject& subject, Output& output);

}  // namespace tumble::tour
