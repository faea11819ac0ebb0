/// @file
/// 5.4 net_wrench: its laws, and what goes wrong.
#include <cmath>
#include <cstddef>
#include <vector>

#include "05_momentum/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/body/forces.hpp"

using namespace tumble::judge;
using momentum::ForceAtBodyPoint, momentum::Wrench;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(momentum::net_wrench)> net_wrench{TUMBLE_UNIT};
}

namespace {

using Forces = std::vector<ForceAtBodyPoint>;

const Vec3 zero = Vec3::Zero();

Wrench reference(double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) {
  const tumble::RigidBody<> body(mass, Mat3::Identity());  // its inertia is not asked for
  const tumble::Derived<> now{x, R, zero, zero};
  tumble::Wrench<> sum = tumble::Weight{g}(0., body, now);
  for (const auto& [force, p_body] : forces)
    sum += tumble::ForceAtBodyPoint{force, p_body}(0., body, now);
  return {sum.force, sum.torque};
}

/// The sum of the sizes of all forces, each times (1 + |x| + |p_body|): metres are taken for the
/// unit of force and torque alike.
double size_of(double mass, const Vec3& x, const Vec3& g, const Forces& forces) {
  double size = mass * g.norm() * (1 + x.norm());
  for (const auto& [force, p_body] : forces) size += force.norm() * (1 + x.norm() + p_body.norm());
  return size;
}

/// A torque takes 13 eps, by way of the body's axes or about the origin some 30; a sum of n one eps
/// for each. Both sides together.
double rounding(double mass, const Vec3& x, const Vec3& g, const Forces& forces) {
  const double n = static_cast<double>(forces.size());
  return (64 + 2 * n) * eps * size_of(mass, x, g, forces);
}

/// What a question consists of.
struct Scene {
  double mass = any_number(0.5, 5);
  Vec3 x = any_vector(3);
  Mat3 R = any_rotation();
  Vec3 g = any_vector(10);
  Forces forces = {};
};

Forces any_forces(int n) {
  Forces forces;
  for (int i = 0; i < n; ++i) forces.push_back({any_vector(20), any_vector(2)});
  return forces;
}

Scene any_scene(int forces) {
  Scene scene;
  scene.forces = any_forces(forces);
  return scene;
}

Answer<Wrench> ask(const Scene& scene) {
  return student::net_wrench(scene.mass, scene.x, scene.R, scene.g, scene.forces);
}

double rounding(const Scene& scene) { return rounding(scene.mass, scene.x, scene.g, scene.forces); }

/// The wrench if the arm of a force, from the centre of mass, were what `arm` makes of its point.
template <class Arm>
Wrench with_arms(double mass, const Vec3& g, const Forces& forces, const Arm& arm) {
  Wrench sum{mass * g, zero};
  for (const auto& [force, p_body] : forces) {
    sum.force += force;
    sum.torque += Vec3(arm(p_body)).cross(force);
  }
  return sum;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any forces at any points of any body, and its weight") {
    for (const int n : {3, 1, 2, 10}) {
      const Scene scene = any_scene(n);
      const auto& [mass, x, R, g, forces] = scene;
      REQUIRE(ask(scene) == close_to(reference(mass, x, R, g, forces), rounding(scene)));
    }
  }

  TEST_CASE("with no other force there is the weight, which does not turn; in orbit nothing") {
    for (int n = 0; n < 5; ++n) {
      Scene scene = any_scene(0);
      REQUIRE(ask(scene) == close_to(Wrench{scene.mass * scene.g, zero}, rounding(scene)));
      scene.g = zero;
      REQUIRE(ask(scene) == close_to(Wrench{zero, zero}, 0));
    }
  }

  TEST_CASE(
      "a force pushes with all its strength wherever it acts, and turns by its arm in the world") {
    for (const double off : {0., 0.1, 1., 10.}) {
      Scene scene = any_scene(0);
      const Vec3 F = any_vector(20), p_body = off * any_direction();
      scene.g = zero;
      scene.forces = {{F, p_body}};
      const Wrench expected{F, Vec3(scene.R * p_body).cross(F)};
      REQUIRE(ask(scene) == close_to(expected, rounding(scene)));
    }
  }

  TEST_CASE("a point turns with the body, a force does not: a body turned by a quarter turn") {
    const Vec3 X = Vec3::UnitX(), Y = Vec3::UnitY(), Z = Vec3::UnitZ();
    Scene scene{1, zero, Mat3::Identity(), zero, {{3 * Y, 2 * X}}};
    REQUIRE(ask(scene) == close_to(Wrench{3 * Y, 6 * Z}, rounding(scene)));
    scene.R << Y, -X, Z;  // now the point is above the centre, and the force goes through both
    REQUIRE(ask(scene) == close_to(Wrench{3 * Y, zero}, rounding(scene)));
    scene.forces = {{3 * X, 2 * X}};
    REQUIRE(ask(scene) == close_to(Wrench{3 * X, -6 * Z}, rounding(scene)));
  }

  TEST_CASE("two opposite forces push a body nowhere, but turn it as they should, wherever it is") {
    for (int n = 0; n < 5; ++n) {
      Scene scene = any_scene(0);
      scene.g = zero;
      const Vec3 F = any_vector(20), p = any_vector(2), other = any_vector(2);
      scene.forces = {{F, p}, {-F, other}};
      const Wrench expected{zero, Vec3(scene.R * (p - other)).cross(F)};
      REQUIRE(ask(scene) == close_to(expected, rounding(scene)));
    }
  }

  TEST_CASE("the wrench of all forces is the sum of the wrenches of two groups, in any order") {
    for (int n = 0; n < 5; ++n) {
      Scene scene = any_scene(4);
      Scene first = scene, second = scene;
      first.forces.resize(1);
      second.forces = {scene.forces[3], scene.forces[2], scene.forces[1]};
      second.g = zero;  // the weight is there only once
      const auto a = ask(first), b = ask(second);
      const Wrench sum{a->force + b->force, a->torque + b->torque};
      REQUIRE(ask(scene) == close_to(sum, 2 * rounding(scene)));
    }
  }

  TEST_CASE("the weights of all parts, each at its own place, turn as little as the whole weight") {
    for (int n = 0; n < 5; ++n) {
      Scene scene = any_scene(0);
      const Vec3 g = scene.g;
      scene.g = zero;
      Vec3 moment = zero, weight = zero;
      for (int i = 0; i < 4; ++i) {
        const double mass = any_number(0.1, 2);
        const Vec3 p_body = any_vector(2);
        moment += mass * p_body;
        weight += mass * g;
        scene.forces.push_back({mass * g, p_body});
      }
      // The last part is of 1 kg, and brings the centre of mass of all to the origin of the body.
      scene.forces.push_back({g, -moment});
      REQUIRE(ask(scene) == close_to(Wrench{weight + g, zero}, rounding(scene)));
    }
  }

  TEST_CASE("many forces, tiny and huge ones, heavy and light bodies") {
    const Scene crowd = any_scene(200);
    REQUIRE(ask(crowd) == close_to(reference(crowd.mass, crowd.x, crowd.R, crowd.g, crowd.forces),
                                   rounding(crowd)));
    for (const double size : {1e-100, 1e-8, 1e8, 1e100}) {
      Scene scene = any_scene(3);
      scene.mass *= size;
      for (auto& [force, p_body] : scene.forces) force *= size;
      const auto& [mass, x, R, g, forces] = scene;
      REQUIRE(ask(scene) == close_to(reference(mass, x, R, g, forces), rounding(scene)));
    }
  }
}

const Misconceptions<decltype(momentum::net_wrench)> misconceptions{
    TUMBLE_UNIT,
    {{"weight forgotten",
      "You have added up the forces of the list, but not the body's weight, which is not one of "
      "them.",
      "Weight",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3&, const Forces& forces) {
        return reference(mass, x, R, zero, forces);
      }},
     {"g taken for a force",
      "You have added g as it is. It is an acceleration: a heavy body is pulled harder than a "
      "light one.",
      "Weight",
      [](double, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) {
        return reference(1, x, R, g, forces);
      }},
     {"weight upwards",
      "Your weight has the wrong sign. g is a vector that already points to where things fall.",
      "Weight",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) {
        return reference(mass, x, R, -g, forces);
      }},
     {"weight once for each force",
      "You have added the weight as often as there are other forces: look at what is inside "
      "your loop.",
      "Weight",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) {
        return reference(mass, x, R, static_cast<double>(forces.size()) * g, forces);
      }},
     {"the weight turns",
      "Your weight has a torque, about the origin of the world. It acts at the centre of mass, "
      "and we want torques about the centre of mass.",
      "Weight",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) -> Wrench {
        Wrench sum = reference(mass, x, R, g, forces);
        sum.torque += x.cross(mass * g);
        return sum;
      }},
     {"points not turned",
      "You have left the arms in body axes, while the forces are in world axes. A point of the "
      "body turns with it.",
      "Frames of reference",
      [](double mass, const Vec3& x, const Mat3&, const Vec3& g, const Forces& forces) {
        return reference(mass, x, Mat3::Identity(), g, forces);
      }},
     {"points turned the wrong way",
      "You have turned the points from world axes to body axes, in which they already are. R "
      "takes body axes to world axes.",
      "Frames of reference",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) {
        return reference(mass, x, R.transpose(), g, forces);
      }},
     {"forces turned as well",
      "You have turned the forces by R together with their points. They are in world axes "
      "already.",
      "Frames of reference",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, Forces forces) {
        for (ForceAtBodyPoint& each : forces) each.force = R * each.force;
        return reference(mass, x, R, g, forces);
      }},
     {"torque left in body axes",
      "You have worked out the torque in body axes and not turned it back. The force is in "
      "world axes, and so the torque has to be.",
      "Frames of reference",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) -> Wrench {
        const Wrench sum = reference(mass, x, R, g, forces);
        return {sum.force, R.transpose() * sum.torque};
      }},
     {"torque about the world's origin",
      "Your arms begin at the origin of the world. A free body turns about its centre of mass, "
      "so let them begin there.",
      "Force and torque",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) {
        return with_arms(mass, g, forces, [&](const Vec3& p) { return x + R * p; });
      }},
     {"turned the other way",
      "All your torques have the wrong sign: the factors of the cross product are swapped, or "
      "the arm points from the force to the centre.",
      "Force and torque",
      [](double mass, const Vec3&, const Mat3& R, const Vec3& g, const Forces& forces) {
        return with_arms(mass, g, forces, [&](const Vec3& p) { return -(R * p); });
      }},
     {"force and torque swapped",
      "You have returned the torque where the force belongs, and the force where the torque "
      "belongs. The force comes first.",
      "Force and torque",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) -> Wrench {
        const Wrench sum = reference(mass, x, R, g, forces);
        return {sum.torque, sum.force};
      }},
     {"only the last force", "Each force has replaced the one before it. Add them up.",
      "Force and torque",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) {
        const std::size_t n = forces.size();
        const Forces last(forces.begin() + (n > 0 ? static_cast<std::ptrdiff_t>(n) - 1 : 0),
                          forces.end());
        return reference(mass, x, R, g, last);
      }},
     {"only the last force, but all torques",
      "Your torque is right. Your force is only the last one: each force has replaced what was "
      "there, "
      "the weight too. Add them up.",
      "Force and torque",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) {
        Wrench sum = reference(mass, x, R, g, forces);
        if (!forces.empty()) sum.force = forces.back().force;
        return sum;
      }},
     {"only the last torque, but all forces",
      "Your force is right. Your torque is only the last one: each torque has replaced the one "
      "before "
      "it. Add them up.",
      "Force and torque",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) {
        Wrench sum = reference(mass, x, R, g, forces);
        if (!forces.empty()) sum.torque = reference(mass, x, R, g, {forces.back()}).torque;
        return sum;
      }},
     {"arms and forces summed first",
      "You have made one torque, of the sum of the arms and the sum of the forces. Now every "
      "force also turns with the arms of all the others.",
      "Force and torque",
      [](double mass, const Vec3&, const Mat3& R, const Vec3& g, const Forces& forces) -> Wrench {
        Vec3 arms = zero, sum = zero;
        for (const auto& [force, p_body] : forces) {
          arms += R * p_body;
          sum += force;
        }
        return {mass * g + sum, arms.cross(sum)};
      }},
     {"only the part towards the centre pushes",
      "You have left the part of a force that is perpendicular to its arm out of the sum of the "
      "forces, as if turning used it up. It turns the body and pushes it too, with all its "
      "strength.",
      "Force and torque",
      [](double mass, const Vec3& x, const Mat3& R, const Vec3& g, const Forces& forces) -> Wrench {
        Wrench sum = reference(mass, x, R, g, forces);
        for (const auto& [force, p_body] : forces) {
          const Vec3 along = (R * p_body).normalized();
          if (along.squaredNorm() > 0) sum.force -= force - along.dot(force) * along;
        }
        return sum;
      }}}};
