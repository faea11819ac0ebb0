/// @file
/// Many bodies: one after the other, and side by side.

#include "common.hpp"
#include "parts.hpp"
#include "support/random.hpp"
#include "support/stopwatch.hpp"
#include "tumble/ensemble.hpp"

namespace scene_chapter {

namespace {

/// Free bricks of all shapes that spin at up to 5 rad/s.
struct Crowd {
  std::vector<RigidBody<>> bodies;
  std::vector<RigidBodyState<>> states;
};

Crowd crowd_of(int count) {
  support::Random random(10);
  Crowd crowd;
  for (int i = 0; i < count; ++i) {
    const Vec3 s = random.vector(0.5, 1.5).cwiseAbs2(), turned = random.vector(-3, 3),
               spin = random.vector(-1, 1);
    const Vec3 moments(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
    const RigidBody<> body(1, moments.asDiagonal());
    crowd.bodies.push_back(body);
    crowd.states.push_back(
        turning_state(body, turn(turned), random.uniform(0, 5) * spin.normalized()));
  }
  return crowd;
}

constexpr int crowd_size = 160, crowd_steps = 240;
constexpr double crowd_step = 1.0 / crowd_steps;  // [s]

/// Root mean square over the bodies after one second [rad].
template <class StateOf>
double crowd_error(const Crowd& crowd, const StateOf& state_of) {
  double sum = 0;
  for (std::size_t i = 0; i < crowd.bodies.size(); ++i) {
    const Quat truth = FreeTrajectory(crowd.bodies[i], crowd.states[i]).at(1).q;
    const double error = angle_between(state_of(i).q, truth);
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(crowd.bodies.size()));
}

/// A way to move all of them by a second.
struct CrowdWay {
  std::string name;
  std::function<std::vector<RigidBodyState<>>(const Crowd&)> end;
};

template <class Method>
CrowdWay one_by_one(const std::string& name, int steps) {
  return {name, [steps](const Crowd& crowd) {
            std::vector<RigidBodyState<>> ends;
            for (std::size_t i = 0; i < crowd.bodies.size(); ++i)
              ends.push_back(unpack<double>(integrate_fixed<Method>(
                  RigidBodyRhs(crowd.bodies[i]), pack(crowd.states[i]), 0, 1, steps)));
            return ends;
          }};
}

template <class Method>
CrowdWay side_by_side(const std::string& name) {
  return {name, [](const Crowd& crowd) {
            Ensemble all(crowd.bodies, crowd.states);
            const LostBodies lost = advance<Method>(all, {crowd_step, crowd_steps});
            require(lost.count == 0, "bodies were lost");
            std::vector<RigidBodyState<>> ends;
            for (std::size_t i = 0; i < all.size(); ++i) ends.push_back(all.state(i));
            return ends;
          }};
}

CrowdWay by_closed_forms() {
  return {"each by its closed form, no steps", [](const Crowd& crowd) {
            std::vector<RigidBodyState<>> ends;
            for (std::size_t i = 0; i < crowd.bodies.size(); ++i)
              ends.push_back(FreeTrajectory(crowd.bodies[i], crowd.states[i]).at(1));
            return ends;
          }};
}

}  // namespace

Table crowd_table() {
  static const Crowd crowd = crowd_of(crowd_size);
  const std::vector<CrowdWay> ways{one_by_one<Rk4>("one by one, RK4 on 13 numbers", crowd_steps),
                                   side_by_side<Rk4>("ensemble, RK4"),
                                   side_by_side<TaylorMagnus<4>>("ensemble, series of order 4"),
                                   side_by_side<TaylorMagnus<6>>("ensemble, order 6"),
                                   side_by_side<TaylorMagnus<8>>("ensemble, order 8"),
                                   by_closed_forms()};
  support::Stopwatch stopwatch;
  for (const CrowdWay& way : ways)
    stopwatch.add(
        way.name, [way] { support::keep(way.end(crowd)); }, 1);
  const std::vector<support::Timing> timings = stopwatch.timings();
  Table table({"way", "a body and step", "as a ratio", "rms error"});
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const std::vector<RigidBodyState<>> ends = ways[i].end(crowd);
    const double error = crowd_error(crowd, [&](std::size_t k) { return ends[k]; });
    table.add({ways[i].name, support::duration(timings[i].seconds / (crowd_size * crowd_steps)),
               support::times(timings[i].seconds / timings[0].seconds),
               error_above(error, 1e-12) + " rad"});
  }
  return table;
}

}  // namespace scene_chapter
