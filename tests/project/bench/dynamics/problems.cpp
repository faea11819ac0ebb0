#include "project/bench/dynamics/problems.hpp"

#include "reference/rigid_body.hpp"
#include "support/random.hpp"

namespace tumble::bench {
namespace {

Problem problem(const std::string& name, const std::string& title, const reference::Motion& motion,
                const Push& push, double condition) {
  const Body body{motion.I_body.diagonal(), {motion.q0, motion.omega_body0}};
  return {name, title, {{body}, push}, motion.duration, motion.q_end, condition};
}

}  // namespace

std::vector<Problem> problems() {
  const Push nothing, weight_of_top{{0, 0, -5}, {0, 0, 1}};
  const Push weight{reference::heavy_force.force, reference::heavy_force.p_body};
  return {problem("free", "FREE: a body near its separatrix, nothing pushes, 100 s",
                  reference::free_body, nothing, 2.7e6),
          problem("top", "TOP: the Lagrange top, 10 s", reference::top, weight_of_top, 400),
          problem("heavy", "HEAVY: a body about a fixed point, no closed form, 10 s",
                  reference::heavy, weight, 50)};
}

Scene crowd(int bodies) {
  support::Random random(6);
  Scene scene;
  for (int i = 0; i < bodies; ++i) {
    const Vec3 s = random.vector(0.5, 1.5).cwiseAbs2();  // sides of a box, squared
    const Vec3 turn = random.vector(-3, 3), spin = random.vector(-1, 1);
    const Vec3 moments(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
    const double rate = random.uniform(0, 5);
    scene.bodies.push_back(
        {moments, {from_axis_angle(turn, turn.norm()), rate * spin.normalized()}});
  }
  return scene;
}

}  // namespace tumble::bench
