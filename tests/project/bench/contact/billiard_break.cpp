// A billiard break: how many collisions come in their order?
#include <algorithm>
#include <cmath>
#include <set>

#include "project/bench/contact/bodies.hpp"
#include "project/bench/contact/problem.hpp"
#include "project/bench/contact/reference_billiards.hpp"
#include "support/random.hpp"

namespace tumble::bench {
namespace {

/// Of how many the two agree.
template <class Events>
std::size_t common(const Events& a, const Events& b) {
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(end.first - a.begin());
}

/// A cue ball, and fifteen in a triangle with small gaps of all sizes, so that no two collisions
/// are at once.
Scene break_off() {
  constexpr double r = 0.028575, mass = 0.17, length = 2.54, width = 1.27;
  support::Random random(15);
  Scene scene;
  scene.planar = true;
  scene.walls = room({length, 0, width});
  scene.bodies.push_back(ball(r, mass, {-0.6, 0, 0.01}, {8, 0, 0.1}));
  for (int row = 0; row < 5; ++row)
    for (int i = 0; i <= row; ++i) {
      const Vec3 place(0.6 + row * std::sqrt(3) * r, 0, (2 * i - row) * r);
      const double x = random.uniform(-1e-4, 1e-4), z = random.uniform(-1e-4, 1e-4);
      scene.bodies.push_back(ball(r, mass, 1.01 * place + Vec3(x, 0, z)));
    }
  return scene;
}

/// Which bodies' velocities a step has changed.
std::set<int> changed(const std::vector<Vec3>& before, const std::vector<Vec3>& now) {
  constexpr double least = 1e-5;  // [m/s]
  std::set<int> bodies;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (!((now[i] - before[i]).norm() <= least)) bodies.insert(static_cast<int>(i));
  return bodies;
}

/// How many of the true collisions come in the steps as they should. Within a step any order is
/// right.
class Follower {
 public:
  explicit Follower(const std::vector<Collision>& truth) : truth_(truth) {}
  /// Whether those that changed are those of the next collisions.
  bool accept(const std::set<int>& bodies) {
    std::set<int> seen;
    for (; right_ < truth_.size(); ++right_) {
      const auto& [a, b] = truth_[right_];
      if (!bodies.count(a) || (b >= 0 && !bodies.count(b))) break;
      seen.insert(a);
      if (b >= 0) seen.insert(b);
    }
    return seen == bodies;
  }
  std::size_t right() const { return right_; }

 private:
  const std::vector<Collision>& truth_;
  std::size_t right_ = 0;
};

std::vector<Vec3> velocities(const Simulation& simulation, std::size_t count) {
  std::vector<Vec3> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(simulation.motion(i).v);
  return all;
}

std::vector<Collision> collisions_of(const contact::ContactRun& run) {
  std::vector<Collision> all;
  for (const contact::ImpactEvent& i : run.impacts)
    all.push_back(i.other < 0 ? Collision{i.body, -1 - i.wall}
                              : Collision{std::min(i.body, i.other), std::max(i.body, i.other)});
  return all;
}

}  // namespace

Problem billiard_break() {
  constexpr double duration = 6;
  const Scene scene = break_off();
  const std::vector<Collision> truth = billiards(scene, duration);
  require(common(truth, billiards(scene, duration, 0x1p-100)) == truth.size(),
          "break: even double-doubles do not know its end");
  const std::size_t bodies = scene.bodies.size();
  const Question question{[truth, bodies](Simulation& simulation, double, int steps) {
                            Follower follower(truth);
                            std::vector<Vec3> before = velocities(simulation, bodies);
                            for (int i = 0; i < steps; ++i) {
                              simulation.advance(1);
                              const std::vector<Vec3> now = velocities(simulation, bodies);
                              if (!follower.accept(changed(before, now))) break;
                              before = now;
                            }
                            return share_missed(follower.right(), truth.size());
                          },
                          [truth](const contact::ContactScene&, const contact::ContactRun& run) {
                            return share_missed(common(truth, collisions_of(run)), truth.size());
                          }};
  const int count = static_cast<int>(truth.size());
  return {
      "break",
      "BREAK: a billiard break of 16 balls, e = 1, " + std::to_string(count) + " collisions in 6 s",
      "share of its collisions that is not in their order",
      scene,
      duration,
      question,
      0.5,
      count};
}

}  // namespace tumble::bench
