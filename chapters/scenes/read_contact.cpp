#include "scenes/read_contact.hpp"

#include <algorithm>

#include "scenes/contact_scene.hpp"

namespace tumble::scenes {
namespace {

using support::Place;

/// The normal may have any length.
collide::HalfSpace half_space(const Place& place, std::initializer_list<const char*> keys) {
  place.require_some(keys);
  const Vec3 normal = place["normal"].vector();
  require(!normal.isZero(0), place.name(), ".normal is zero: give it the direction to the bodies");
  return {place["point"].vector(), normal.stableNormalized()};
}

SceneWall read_floor(const Place& place) {
  if (place.is_object()) return {"floor", half_space(place, {"point", "normal"})};
  return {"floor", {Vec3(0, 0, place.number()), Vec3::UnitZ()}};
}

SceneWall read_wall(const Place& place, std::size_t index) {
  const collide::HalfSpace space = half_space(place, {"name", "point", "normal"});
  return {place.has("name") ? place["name"].text() : "wall " + std::to_string(index + 1), space};
}

}  // namespace

std::optional<SceneContact> read_contact(const Place& root) {
  const auto keys = {"floor", "walls", "restitution", "friction"};
  if (std::none_of(keys.begin(), keys.end(), [&](const char* key) { return root.has(key); }))
    return {};
  SceneContact contact;
  contact.restitution = root.number_or("restitution", contact.restitution);
  require(contact.restitution >= 0 && contact.restitution <= 1, root.name(), ".restitution is ",
          contact.restitution, "; it must be between 0 and 1");
  contact.friction = root.number_or("friction", contact.friction);
  require(contact.friction >= 0, root.name(), ".friction is ", contact.friction,
          "; it must be 0 or more");
  if (root.has("floor")) contact.walls.push_back(read_floor(root["floor"]));
  if (root.has("walls")) {
    const std::vector<Place> walls = root["walls"].elements();
    for (std::size_t i = 0; i < walls.size(); ++i) contact.walls.push_back(read_wall(walls[i], i));
  }
  return contact;
}

void require_apart(const Place& root, const Scene& scene) {
  const std::vector<Place> bodies = root["bodies"].elements();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (const SceneWall& wall : scene.contact->walls) {
      const SceneBody& body = scene.bodies[i];
      const double gap =
          distance(body.shape->convex, {body.start.x, to_matrix(body.start.q)}, wall.half_space)
              .gap;
      require(gap >= -contact_tolerance(scene), bodies[i].name(), ": ", support::escaped(body.name),
              " starts ", -gap, " m deep in the ", support::escaped(wall.name));
    }
  root.refused_here([&] { contact_scene(scene).require_valid(contact_tolerance(scene)); });
}

}  // namespace tumble::scenes
