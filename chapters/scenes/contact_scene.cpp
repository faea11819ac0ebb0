#include "scenes/contact_scene.hpp"

#include <algorithm>

#include "support/printable.hpp"

namespace tumble::scenes {

contact::ContactScene contact_scene(const Scene& scene) {
  contact::ContactScene made{
      {}, {}, scene.gravity, scene.contact->restitution, scene.contact->friction};
  for (const SceneBody& body : scene.bodies)
    made.bodies.push_back({support::escaped(body.name), body.body, body.shape->convex, body.start});
  for (const SceneWall& wall : scene.contact->walls) made.walls.push_back(wall.half_space);
  return made;
}

double contact_tolerance(const Scene& scene) {
  constexpr double most = 1e-8;  // more would blur the lowest hops
  double least = scene.bodies.front().shape->convex.reach();
  for (const SceneBody& body : scene.bodies) least = std::min(least, body.shape->convex.reach());
  return least * std::min(most, scene.task.tolerance);
}

}  // namespace tumble::scenes
