#pragma once
/// @file
/// What a film strip shows of a scene, and from where.

#include <vector>

#include "scenes/motions.hpp"

namespace tumble::scenes {

/// A body at one time.
struct FilmPicture {
  std::size_t body;
  RigidBodyState<> state;
  bool last;  ///< at the end of the film
};

/// Seen from the side of the longest way, a little from above.
struct FilmScene {
  std::vector<FilmPicture> pictures;      ///< far ones first
  std::vector<std::vector<Vec3>> paths;   ///< of each body's centre [m]
  std::vector<std::vector<Vec3>> ground;  ///< lines on floors, and on walls that were hit [m]
  Mat3 view;                              ///< to the viewer's axes: right, up, towards the viewer
  double between;                         ///< two pictures [s]
};

/// @param scene with contact
FilmScene film_scene(const Scene& scene, const Motions& motions);

}  // namespace tumble::scenes
