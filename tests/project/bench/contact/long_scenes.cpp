// Scenes that forget how they began: how many contacts does an answer stay right?
#include <algorithm>
#include <cmath>
#include <set>

#include "project/bench/contact/bodies.hpp"
#include "project/bench/contact/problem.hpp"
#include "project/bench/contact/reference_billiards.hpp"
#include "project/bench/contact/reference_brick.hpp"
#include "support/random.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::bench {
namespace {

/// What is right of all, as an error.
double share_missed(std::size_t right, std::size_t all) {
  return 1 - static_cast<double>(right) / static_cast<double>(all);
}

/// Of how many the two agree.
template <class Events>
std::size_t common(const Events& a, const Events& b) {
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(end.first - a.begin());
}

// ── A billiard break ──

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

Problem billiard_break() {
  constexpr double duration = 6;
  const Scene scene = break_off();
  const std::vector<Collision> truth = billiards(scene, duration);
  require(common(truth, billiards(scene, duration, 0x1p-100)) == truth.size(),
          "break: even double-doubles do not know its end");
  const std::size_t bodies = scene.bodies.size();
  const Question question{
      [truth, bodies](Simulation& simulation, double, int steps) {
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
  return {"break", "BREAK: a billiard break of 16 balls, e = 1, " + std::to_string(count) +
                       " collisions in 6 s",
          "share of its collisions that is not in their order", scene, duration, question, 0.5, count};
}

// ── A brick in a room ──

constexpr double off = 0.1;  // [rad]

struct Bounce {
  double t;
  Quat q;
};

Scene room_with_brick() {
  Scene scene;
  scene.walls = room({0.5, 0.4, 0.6});
  scene.bodies.push_back(box({0.2, 0.12, 0.05}, 1, {0.01, 0.02, -0.03}, {0.9, 0.3, -0.2, 0.25}));
  scene.bodies[0].start.v = {0.9, -0.7, 1.1};
  scene.bodies[0].start.omega = {2, 3, -1};
  return scene;
}

std::vector<Bounce> bounces(const Scene& scene, int count, double nudge) {
  ReferenceBrick reference(scene, nudge);
  std::vector<Bounce> all;
  for (int i = 0; i < count; ++i) {
    reference.next_impact();
    all.push_back({reference.t(), reference.motion().q});
  }
  return all;
}

/// Before which of them the angle to `q_at(t)` has become too large.
template <class Orientation>
std::size_t followed(const std::vector<Bounce>& truth, Orientation q_at) {
  std::size_t right = 0;
  while (right < truth.size() && angle_between(q_at(truth[right].t), truth[right].q) <= off) ++right;
  return right;
}

/// At times that lie in a row, by the steps before and a turn by the ω of then.
class OrientationOfSteps {
 public:
  OrientationOfSteps(Simulation& simulation, double h) : simulation_(simulation), h_(h) {}
  Quat operator()(double t) {
    const int steps = static_cast<int>(t / h_);
    simulation_.advance(steps - done_);
    done_ = steps;
    const Motion now = simulation_.motion(0);
    const Vec3 turn = (t - steps * h_) * now.omega;
    return from_axis_angle(turn, turn.norm()) * now.q.normalized();
  }

 private:
  Simulation& simulation_;
  double h_;
  int done_ = 0;
};

Problem brick_in_room() {
  constexpr int count = 40;
  const Scene scene = room_with_brick();
  const std::vector<Bounce> truth = bounces(scene, count, 0);
  const std::vector<Bounce> nudged = bounces(scene, count, 0x1p-100);
  require(angle_between(nudged.back().q, truth.back().q) < 1e-3 * off,
          "room: even double-doubles do not know its end");
  const Question question{
      [truth](Simulation& simulation, double h, int) {
        return share_missed(followed(truth, OrientationOfSteps(simulation, h)), truth.size());
      },
      [truth](const contact::ContactScene& bodies, const contact::ContactRun& run) {
        const auto q_at = [&](double t) { return run.state(bodies, 0, t).q; };
        return share_missed(followed(truth, q_at), truth.size());
      }};
  return {"room",
          "ROOM: a brick among six walls, no friction, e = 1, " + std::to_string(count) + " bounces",
          "share of its bounces before which it is 0.1 rad off",
          scene,
          truth.back().t,
          question,
          0.5,
          count};
}

}  // namespace

std::vector<Problem> long_problems() { return {billiard_break(), brick_in_room()}; }

}  // namespace tumble::bench
