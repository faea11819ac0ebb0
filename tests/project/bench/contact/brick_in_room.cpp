// A brick in a room: before how many bounces does an answer stay right?
#include "project/bench/contact/bodies.hpp"
#include "project/bench/contact/problem.hpp"
#include "project/bench/contact/reference_brick.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::bench {
namespace {

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
  while (right < truth.size() && angle_between(q_at(truth[right].t), truth[right].q) <= off)
    ++right;
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

}  // namespace

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
  return {
      "room",
      "ROOM: a brick among six walls, no friction, e = 1, " + std::to_string(count) + " bounces",
      "share of its bounces before which it is 0.1 rad off",
      scene,
      truth.back().t,
      question,
      0.5,
      count};
}

}  // namespace tumble::bench
