#include "scenes/read_springs.hpp"

#include "scenes/find_body.hpp"

namespace tumble::scenes {
namespace {

using support::Place;

/// A body's number, and the point of it, from its centre of mass.
struct End {
  std::size_t body;
  Vec3 p_body;
};

End read_end(const Place& place, const std::vector<SceneBody>& bodies) {
  place.require_some({"body", "at"});
  const std::size_t body = find_body(place["body"], bodies);
  require(!bodies[body].held, place.name(), ".body: ", support::escaped(bodies[body].name),
          " is held at a point. Give it a spring to the world, or let it go");
  const Vec3 centre = bodies[body].centre;
  return {body, place.has("at") ? Vec3(place["at"].vector() - centre) : Vec3(0, 0, 0)};
}

SpringBetween read_spring(const Place& place, const std::vector<SceneBody>& bodies) {
  place.require_some({"from", "to", "stiffness", "length", "damping"});
  const End from = read_end(place["from"], bodies), to = read_end(place["to"], bodies);
  require(from.body != to.body, place.name(), " joins ", support::escaped(bodies[from.body].name),
          " to itself");
  SpringBetween spring{from.body,
                       to.body,
                       from.p_body,
                       to.p_body,
                       place["stiffness"].number(),
                       place.number_or("length", 0),
                       place.number_or("damping", 0)};
  place.refused_here([&] { spring.require_valid(); });
  return spring;
}

}  // namespace

std::vector<SpringBetween> read_springs(const Place& springs,
                                        const std::vector<SceneBody>& bodies) {
  std::vector<SpringBetween> all;
  for (const Place& spring : springs.elements()) all.push_back(read_spring(spring, bodies));
  return all;
}

}  // namespace tumble::scenes
