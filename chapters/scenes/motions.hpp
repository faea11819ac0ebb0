#pragma once
/// @file
/// How the bodies of a scene move, up to the end or to where the scene is stopped.

#include <optional>
#include <vector>

#include "scenes/scene.hpp"
#include "tumble/contact/contact_run.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::scenes {

/// A run of bodies that touched, or may have. Its times count from the start of the scene.
struct Contacts {
  contact::ContactScene scene;
  contact::ContactSettings settings;
  contact::ContactRun run;
};

/// Of each body a trajectory, or of all of them a run with contacts.
struct Motions {
  std::vector<Trajectory> trajectories = {};
  std::optional<Contacts> contacts = {};
  double start = 0, end = 0;  ///< [s]
  bool stopped = false;       ///< by stop_when

  /// @param t from `start` to `end` [s]
  RigidBodyState<> at(std::size_t body, double t) const {
    return contacts ? contacts->run.state(contacts->scene, static_cast<int>(body), t - start)
                    : trajectories[body].at(t);
  }
};

/// Follows each body by itself, or from impact to impact where the scene has contact and bodies can
/// touch something.
/// @throws std::runtime_error if a motion cannot be followed to its end
Motions move(const Scene& scene);

/// When states are recorded [s], the last time at the end.
std::vector<double> record_times(const Scene& scene, const Motions& motions);

}  // namespace tumble::scenes
