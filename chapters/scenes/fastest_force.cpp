#include "scenes/fastest_force.hpp"

#include <algorithm>

#include "scenes/joined_motion.hpp"
#include "support/printable.hpp"
#include "tumble/body/force_pace.hpp"

namespace tumble::scenes {
namespace {

using detail::ForcePace, detail::ForcePaces, detail::paces;

void append(ForcePaces& all, const ForcePaces& more) {
  all.insert(all.end(), more.begin(), more.end());
}

template <class Body>
ForcePaces paces_of(const SceneBody& body, const Body& moved) {
  ForcePaces all = paces(body.steady, moved);
  for (const SpringToWorld& spring : body.springs) append(all, paces(spring, moved));
  return all;
}

ForcePaces paces_of(const SceneBody& body) {
  return body.held ? paces_of(body, *body.held) : paces_of(body, body.body);
}

std::string advice_about(const ForcePaces& all, double duration) {
  constexpr double fast = 1e5;  // of movements in a motion
  const auto fastest =
      std::max_element(all.begin(), all.end(),
                       [](const ForcePace& a, const ForcePace& b) { return a.rate < b.rate; });
  if (fastest == all.end() || !(fastest->rate * duration > fast)) return "";
  return fastest->advice(duration);
}

}  // namespace

std::string fastest_force(const SceneBody& body, double duration) {
  return advice_about(paces_of(body), duration);
}

std::string fastest_joined_force(const Scene& scene) {
  ForcePaces all;
  for (const std::size_t body : joined_bodies(scene)) append(all, paces_of(scene.bodies[body]));
  std::vector<RigidBody<>> bodies;
  for (const SceneBody& body : scene.bodies) bodies.push_back(body.body);
  for (const SpringBetween& spring : scene.springs)
    append(all, paces(spring, std::span<const RigidBody<>>(bodies)));
  return advice_about(all, scene.task.t1 - scene.task.t0);
}

}  // namespace tumble::scenes
