#include "scenes/joined_motion.hpp"

#include <algorithm>
#include <memory>
#include <set>

#include "tumble/simulate/simulate_bodies.hpp"

namespace tumble::scenes {
namespace {

/// One body of several that move together.
class OneOfAll final : public detail::AnyTrajectory<RigidBodyState<>> {
 public:
  OneOfAll(SceneTrajectory all, std::size_t body) : all_(std::move(all)), body_(body) {}

  RigidBodyState<> at(double t) const override { return all_.at(t)[body_]; }
  std::vector<double> times() const override { return all_.times(); }

 private:
  SceneTrajectory all_;
  std::size_t body_;
};

/// All that pushes the joined bodies: each body's own forces, and the springs between them.
class JoinedForces {
 public:
  JoinedForces(const Scene& scene, const std::vector<std::size_t>& joined) {
    for (const std::size_t body : joined) bodies_.push_back(scene.bodies[body]);
    const auto place = [&](std::size_t body) {
      return static_cast<std::size_t>(std::lower_bound(joined.begin(), joined.end(), body) -
                                      joined.begin());
    };
    for (SpringBetween spring : scene.springs) {
      spring.a = place(spring.a);
      spring.b = place(spring.b);
      springs_.push_back(spring);
    }
  }

  void operator()(double t, std::span<const RigidBody<>> bodies, std::span<const Derived<>> now,
                  std::span<Wrench<>> net) const {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      net[i] += bodies_[i].steady(t, bodies[i], now[i]);
      for (const SpringToWorld& spring : bodies_[i].springs) net[i] += spring(t, bodies[i], now[i]);
    }
    for (const SpringBetween& spring : springs_) spring(t, bodies, now, net);
  }

 private:
  std::vector<SceneBody> bodies_;
  std::vector<SpringBetween> springs_;
};

}  // namespace

std::vector<std::size_t> joined_bodies(const Scene& scene) {
  std::set<std::size_t> joined;
  for (const SpringBetween& spring : scene.springs) joined.insert({spring.a, spring.b});
  return {joined.begin(), joined.end()};
}

std::vector<Trajectory> move_joined(const Scene& scene, const std::vector<std::size_t>& joined) {
  if (joined.empty()) return {};
  std::vector<RigidBody<>> bodies;
  std::vector<RigidBodyState<>> starts;
  for (const std::size_t body : joined) {
    bodies.push_back(scene.bodies[body].body);
    starts.push_back(scene.bodies[body].start);
  }
  const SceneTrajectory all = simulate(bodies, starts, scene.task, JoinedForces(scene, joined));
  std::vector<Trajectory> each;
  for (std::size_t i = 0; i < joined.size(); ++i)
    each.emplace_back(std::make_shared<const OneOfAll>(all, i), all.t0(), all.t1(), all.report());
  return each;
}

}  // namespace tumble::scenes
