#include "project/bench/contact/nothing_meets.hpp"

#include <cmath>

#include "project/bench/least_times.hpp"
#include "support/random.hpp"
#include "tumble/contact/can_touch.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/simulate/simulate.hpp"

namespace tumble::bench {
namespace {

constexpr double flight_time = 10;  // [s]
constexpr int frames = 600;         // 60 a second
constexpr double spacing = 10;      // [m], of boxes that reach 0.57 m
constexpr double deepest = -1e3;    // [m], a floor that nobody reaches

/// Boxes on a lattice, that spin and drift while they fall.
contact::ContactScene scattered_boxes(int count) {
  const Vec3 size(0.2, 0.5, 1);
  const RigidBody<> body(mass_properties(Box{size}, 1000));
  const int side = static_cast<int>(std::ceil(std::cbrt(count) - 1e-9));
  support::Random random(7);
  contact::ContactScene scene;
  scene.walls = {{Vec3(0, 0, deepest), Vec3::UnitZ()}};
  for (int i = 0; i < count; ++i) {
    const Vec3 x = spacing * Vec3(i % side, i / side % side, i / side / side);
    const Vec3 v = random.vector(0.1), omega = random.vector(1);
    scene.bodies.push_back({"box", body, collide::Convex::box(size),
                            state_of_motion<double>(body, x, Quat::Identity(), v, omega)});
  }
  return scene;
}

/// Each body's motion, and so many states of it.
double fly(const contact::ContactScene& scene, int states) {
  double sum = 0;
  for (const contact::ContactBody& b : scene.bodies) {
    const Trajectory way = simulate(b.body, b.start, {.t1 = flight_time}, Weight{scene.gravity});
    for (int k = 1; k <= states; ++k) sum += way.at(k * flight_time / states).x.z();
  }
  return sum;
}

}  // namespace

NothingMeets nothing_meets(const Budget& budget) {
  NothingMeets made{support::Table({"bodies", "can_touch [ns a body]", "simulate [ns a body]",
                                    "with 600 states", "can_touch costs of it"}),
                    {}};
  for (const int count : {1, 10, 100, 1000}) {
    const contact::ContactScene scene = scattered_boxes(count);
    if (can_touch(scene, flight_time))
      made.broken += "; " + std::to_string(count) + " boxes that never meet can touch";
    const auto timed = [&](const std::function<double()>& run) {
      return Timed{run, budget.repetitions, budget.seconds, Clock::thread};
    };
    const std::vector<double> seconds = least_times(
        {timed([&] { return can_touch(scene, flight_time) ? 1. : 0.; }),
         timed([&] { return fly(scene, 1); }), timed([&] { return fly(scene, frames); })});
    const auto each = [&](double s) { return support::number(1e9 * s / count); };
    made.table.add({std::to_string(count), each(seconds[0]), each(seconds[1]), each(seconds[2]),
                    support::number(100 * seconds[0] / seconds[2], 2) + " %"});
  }
  return made;
}

}  // namespace tumble::bench
