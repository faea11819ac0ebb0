/// @file
/// 1.2 dydt: its laws, and what goes wrong.
#include <limits>

#include "01_particles/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/particles/drag.hpp"
#include "tumble/particles/particle_system.hpp"
#include "tumble/particles/spring.hpp"
#include "tumble/particles/uniform_gravity.hpp"

using namespace tumble::judge;
using Eigen::VectorXd;
using particles::Spring;
using particles::System;
using tumble::Vec3;

namespace student {
const Function<decltype(particles::dydt)> dydt{TUMBLE_UNIT};
}

namespace {

int count_of(const System& system) { return static_cast<int>(system.masses.size()); }
double mass_of(const System& system, int n) { return system.masses[static_cast<std::size_t>(n)]; }
Vec3 x_of(const VectorXd& y, int n) { return y.segment<3>(6 * n); }
Vec3 v_of(const VectorXd& y, int n) { return y.segment<3>(6 * n + 3); }

VectorXd reference(const System& system, double t, const VectorXd& y) {
  std::vector<tumble::particles::Particle<double>> list;
  for (int n = 0; n < count_of(system); ++n)
    list.push_back({mass_of(system, n), x_of(y, n), v_of(y, n)});
  const auto springs = [&](double, const tumble::particles::ParticlesView<double>& view,
                           const tumble::particles::ForceSums<double>& push) {
    for (const auto& [i, j, stiffness, damping, rest_length] : system.springs)
      tumble::particles::Spring{i, j, stiffness, damping, rest_length}(t, view, push);
  };
  return tumble::particles::ParticleSystem(list, tumble::particles::UniformGravity{system.gravity},
                                           tumble::particles::LinearDrag{system.linear_drag},
                                           tumble::particles::QuadraticDrag{system.quadratic_drag},
                                           springs)
      .dydt(t, y);
}

// ── Inputs ──

VectorXd any_state(int count, double size = 3) {
  VectorXd y(6 * count);
  for (double& number : y) number = any_number(-size, size);
  return y;
}

Spring any_spring(int i, int j) {
  return {i, j, any_number(1, 20), any_number(0.5, 3), any_number(0.5, 3)};
}

/// Nothing acts on these particles.
System free_particles(int count) {
  System system{{}, Vec3::Zero(), 0, 0, {}};
  for (int n = 0; n < count; ++n) system.masses.push_back(any_number(0.2, 5));
  return system;
}

/// A ring of particles: each is joined to the next, the last to the first.
System ring(int count) {
  System system = free_particles(count);
  for (int n = 0; n < count; ++n) system.springs.push_back(any_spring(n, (n + 1) % count));
  return system;
}

/// Everything acts on these.
System any_system(int count) {
  System system = ring(count);
  system.gravity = any_vector(10);
  system.linear_drag = any_number(0.2, 1);
  system.quadratic_drag = any_number(0.2, 1);
  return system;
}

double any_time() { return any_number(-5, 5); }

/// y with the velocities of all particles set to v.
VectorXd all_moving(VectorXd y, const Vec3& v) {
  for (Eigen::Index place = 3; place < y.size(); place += 6) y.segment<3>(place) = v;
  return y;
}

// ── How exact ──

/// The size of all that is added up in a spring's force, and nearly cancels at times.
double size_of(const Spring& spring, const VectorXd& y) {
  const double length = (x_of(y, spring.i) - x_of(y, spring.j)).norm();
  const double speed = (v_of(y, spring.i) - v_of(y, spring.j)).norm();
  return spring.stiffness * (length + spring.rest_length) + spring.damping * speed;
}

/// Any number of ẏ: a force takes at most 12 roundings of its size, on either side, and their sum
/// one for each of its terms; weight, drag and drag are three.
double rounding(const System& system, const VectorXd& y) {
  double largest = 0;
  for (int n = 0; n < count_of(system); ++n) {
    const double m = mass_of(system, n), v = v_of(y, n).norm();
    double size =
        m * system.gravity.norm() + system.linear_drag * v + system.quadratic_drag * v * v;
    for (const Spring& spring : system.springs)
      if (spring.i == n || spring.j == n) size += size_of(spring, y);
    largest = std::fmax(largest, size / m);
  }
  return static_cast<double>(24 + 2 * (3 + system.springs.size())) * eps * largest;
}

/// What rounding may do to a sum over all particles of mass times acceleration.
double rounding_of_sum(const System& system, const VectorXd& y) {
  double mass = 0;
  for (const double m : system.masses) mass += m;
  return (count_of(system) + 1) * mass * rounding(system, y);
}

// ── Wrong laws ──

using Force = std::function<Vec3(const System&, double mass, const Vec3& v)>;
struct Ends {
  Vec3 on_i, on_j;
};
/// The forces on both ends, from l = xᵢ − xⱼ and its rate.
using Pull = std::function<Ends(const Spring&, const Vec3& l, const Vec3& rate)>;

Vec3 right_force(const System& s, double mass, const Vec3& v) {
  return mass * s.gravity - s.linear_drag * v - s.quadratic_drag * v.norm() * v;
}

double tension(const Spring& s, const Vec3& l, const Vec3& rate) {
  return s.stiffness * (l.norm() - s.rest_length) + s.damping * rate.dot(l.normalized());
}

Ends opposite(const Vec3& on_i) { return {on_i, -on_i}; }

Ends right_pull(const Spring& s, const Vec3& l, const Vec3& rate) {
  return opposite(-tension(s, l, rate) * l.normalized());  // normalized() leaves zero alone
}

VectorXd with_laws(const System& system, const VectorXd& y, const Force& force, const Pull& pull) {
  VectorXd ydot(y.size());
  for (int n = 0; n < count_of(system); ++n)
    ydot.segment<6>(6 * n) << v_of(y, n), force(system, mass_of(system, n), v_of(y, n));
  for (const Spring& s : system.springs) {
    const Ends ends = pull(s, x_of(y, s.i) - x_of(y, s.j), v_of(y, s.i) - v_of(y, s.j));
    ydot.segment<3>(6 * s.i + 3) += ends.on_i;
    ydot.segment<3>(6 * s.j + 3) += ends.on_j;
  }
  for (int n = 0; n < count_of(system); ++n) ydot.segment<3>(6 * n + 3) /= mass_of(system, n);
  return ydot;
}

auto with_force(Force force) {
  return [force = std::move(force)](const System& system, double, const VectorXd& y) {
    return with_laws(system, y, force, right_pull);
  };
}
auto with_pull(Pull pull) {
  return [pull = std::move(pull)](const System& system, double, const VectorXd& y) {
    return with_laws(system, y, right_force, pull);
  };
}

/// (x₁, x₂, …, v₁, v₂, …) from (x₁, v₁, x₂, v₂, …).
VectorXd positions_first(const VectorXd& y) {
  const Eigen::Index count = y.size() / 6;
  VectorXd z(y.size());
  for (Eigen::Index n = 0; n < count; ++n) {
    z.segment<3>(3 * n) = y.segment<3>(6 * n);
    z.segment<3>(3 * (count + n)) = y.segment<3>(6 * n + 3);
  }
  return z;
}
VectorXd positions_first_undone(const VectorXd& z) {
  const Eigen::Index count = z.size() / 6;
  VectorXd y(z.size());
  for (Eigen::Index n = 0; n < count; ++n)
    y.segment<6>(6 * n) << z.segment<3>(3 * n), z.segment<3>(3 * (count + n));
  return y;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("weight, both drags and springs act together on any particles") {
    for (const int count : {3, 2, 5, 6}) {
      for (int n = 0; n < 4; ++n) {
        const System system = any_system(count);
        const VectorXd y = any_state(count);
        const double t = any_time();
        REQUIRE(student::dydt(system, t, y) ==
                close_to(reference(system, t, y), rounding(system, y)));
      }
    }
  }

  TEST_CASE("the position changes at the velocity, which stays, or changes by what acts") {
    for (const int count : {1, 2, 5}) {
      const System system = free_particles(count);
      const VectorXd y = any_state(count);
      REQUIRE(student::dydt(system, any_time(), y) == close_to(reference(system, 0, y), 0));
    }
    const System system = any_system(4);
    const VectorXd y = any_state(4);
    const auto ydot = student::dydt(system, any_time(), y);
    REQUIRE(ydot == close_to(reference(system, 0, y), rounding(system, y)));
    for (int n = 0; n < count_of(system); ++n)
      REQUIRE(ydot == obeys("ẋ = v, unrounded", (x_of(ydot, n) - v_of(y, n)).norm(), 0));
  }

  TEST_CASE("heavy and light fall alike: the acceleration is that of free fall") {
    System system = free_particles(5);
    system.gravity = any_vector(10);
    const VectorXd y = any_state(5);
    const VectorXd expected = reference(system, 0, y);
    for (const double mass : {1e-20, 1., 1e20}) {
      system.masses[2] = mass;
      REQUIRE(student::dydt(system, any_time(), y) == close_to(expected, rounding(system, y)));
    }
  }

  TEST_CASE("drag is against the velocity, and the fastest fall is where it carries the weight") {
    for (const auto& [k, c] : {std::pair(0.7, 0.), std::pair(0., 0.4), std::pair(0.7, 0.4)}) {
      System system = free_particles(3);
      system.linear_drag = k;
      system.quadratic_drag = c;
      const VectorXd y = any_state(3);
      REQUIRE(student::dydt(system, any_time(), y) ==
              close_to(reference(system, 0, y), rounding(system, y)));

      // A mass for which k v + c v² is the weight m g.
      const double g = 9.81, speed = any_number(1, 20);
      const Vec3 down = any_direction();
      system.gravity = g * down;
      system.masses = {(k * speed + c * speed * speed) / g};
      VectorXd fall = any_state(1);
      fall.tail<3>() = speed * down;
      VectorXd steady = VectorXd::Zero(6);
      steady.head<3>() = fall.tail<3>();
      // The speed's and the mass's own roundings count too.
      REQUIRE(student::dydt(system, any_time(), fall) ==
              close_to(steady, 2 * rounding(system, fall)));
    }
  }

  TEST_CASE(
      "a spring of 2 m and 10 N/m, 3 m long, pulls both ends with 10 N; 1 m long, it pushes") {
    const System system{{2, 5}, Vec3::Zero(), 0, 0, {{0, 1, 10, 0, 2}}};
    for (const auto& [length, force] :
         {std::pair(3., 10.), std::pair(2., 0.), std::pair(1., -10.)}) {
      VectorXd y = VectorXd::Zero(12), ydot = VectorXd::Zero(12);
      y[6] = length;  // particle 1 is at x = length
      ydot[3] = force / 2;
      ydot[9] = -force / 5;
      REQUIRE(student::dydt(system, any_time(), y) == close_to(ydot, rounding(system, y)));
    }
  }

  TEST_CASE("springs pull as they should, and bring in no momentum and no angular momentum") {
    for (const int count : {2, 3, 6}) {
      const System system = ring(count);
      const VectorXd y = any_state(count);
      const auto ydot = student::dydt(system, any_time(), y);
      REQUIRE(ydot == close_to(reference(system, 0, y), rounding(system, y)));
      Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
      for (int n = 0; n < count; ++n) {
        const Vec3 F = mass_of(system, n) * v_of(ydot, n);
        force += F;
        torque += x_of(y, n).cross(F);
      }
      const double bound = rounding_of_sum(system, y);
      REQUIRE(ydot == obeys("Σ m v̇ = 0", force.norm(), 2 * bound));
      REQUIRE(ydot == obeys("Σ x × m v̇ = 0", torque.norm(), 4 * bound * y.cwiseAbs().maxCoeff()));
    }
  }

  TEST_CASE("a spring that is carried along or circles pulls by its stretch alone, undamped") {
    for (int n = 0; n < 5; ++n) {
      const System system = ring(2);  // two springs between the same two particles
      const VectorXd y = any_state(2);
      const VectorXd still = all_moving(y, Vec3::Zero()), carried = all_moving(y, any_vector(5));
      // Carried along together, the ends are pulled as at rest.
      VectorXd expected = reference(system, 0, still);
      expected.head<3>() = expected.segment<3>(6) = v_of(carried, 0);
      REQUIRE(student::dydt(system, any_time(), carried) ==
              close_to(expected, rounding(system, carried)));
      // Circling one another too: across the spring, up to the rounding of that direction.
      const Vec3 l = x_of(y, 0) - x_of(y, 1), across = any_direction().cross(l);
      VectorXd circling = still;
      circling.segment<3>(3) = across;
      expected.head<3>() = across;
      expected.segment<3>(6).setZero();
      REQUIRE(student::dydt(system, any_time(), circling) ==
              close_to(expected, 2 * rounding(system, circling)));
    }
  }

  TEST_CASE("a spring whose ends are at the same place does not pull, and all else acts as ever") {
    System system = any_system(3);
    VectorXd y = any_state(3);
    y.segment<3>(6) = y.head<3>();
    REQUIRE(student::dydt(system, any_time(), y) ==
            close_to(reference(system, 0, y), rounding(system, y)));
    y.segment<3>(9) = y.segment<3>(3);  // and both at the same velocity
    REQUIRE(student::dydt(system, any_time(), y) ==
            close_to(reference(system, 0, y), rounding(system, y)));
  }

  TEST_CASE("no particle at all, one alone, tiny and huge speeds and lengths") {
    const System nothing = free_particles(0);
    REQUIRE(student::dydt(nothing, any_time(), VectorXd(0)) == close_to(VectorXd(0), 0));
    System alone = free_particles(1);
    alone.gravity = any_vector(10);
    alone.quadratic_drag = 0.3;
    for (const double size : {0., 1e-90, 1e-8, 1e8, 1e90}) {
      const VectorXd y = any_state(1, size);
      REQUIRE(student::dydt(alone, any_time(), y) ==
              close_to(reference(alone, 0, y), rounding(alone, y)));
      const System system = any_system(3);
      const VectorXd three = any_state(3, size);
      REQUIRE(student::dydt(system, any_time(), three) ==
              close_to(reference(system, 0, three), rounding(system, three)));
    }
  }
}

const Misconceptions<decltype(particles::dydt)> misconceptions{
    TUMBLE_UNIT,
    {{"force for acceleration",
      "In the places of v̇ you have forces. How fast a velocity changes also depends on how heavy "
      "the "
      "particle is.",
      "The right-hand side",
      [](const System& system, double t, const VectorXd& y) {
        VectorXd ydot = reference(system, t, y);
        for (int n = 0; n < count_of(system); ++n) ydot.segment<3>(6 * n + 3) *= mass_of(system, n);
        return ydot;
      }},
     {"multiplied by the mass",
      "You have multiplied the force by the mass. Divide: the same force accelerates a heavy "
      "particle "
      "less.",
      "The right-hand side",
      [](const System& system, double t, const VectorXd& y) {
        VectorXd ydot = reference(system, t, y);
        for (int n = 0; n < count_of(system); ++n)
          ydot.segment<3>(6 * n + 3) *= mass_of(system, n) * mass_of(system, n);
        return ydot;
      }},
     {"gravity taken for a force",
      "You have added the acceleration of free fall to the forces as it is, so the heavy fall more "
      "slowly. Make a force of it first: the weight is mass times acceleration.",
      "Forces",
      with_force([](const System& s, double, const Vec3& v) { return right_force(s, 1, v); })},
     {"drag taken for an acceleration",
      "You have not divided the drag by the mass. It is a force: it slows the heavy less than the "
      "light.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) -> Vec3 {
        return mass * right_force(s, 1, v);
      })},
     {"weight upwards",
      "The weight has the wrong sign: your particles fall upwards. The acceleration of free fall "
      "is a vector that already points downwards.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) -> Vec3 {
        return right_force(s, mass, v) - 2 * mass * s.gravity;
      })},
     {"linear drag forgotten",
      "You have left out the drag that grows with the speed itself. Both drags act together.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) -> Vec3 {
        return right_force(s, mass, v) + s.linear_drag * v;
      })},
     {"quadratic drag forgotten",
      "You have left out the drag that grows with the square of the speed. Both drags act "
      "together.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) -> Vec3 {
        return right_force(s, mass, v) + s.quadratic_drag * v.norm() * v;
      })},
     {"half of the quadratic drag",
      "Your quadratic drag is half of what it should be. A textbook writes ½ ρ c A |v| v; here c "
      "stands "
      "for all of ½ ρ c A.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) {
        System half = s;
        half.quadratic_drag /= 2;
        return right_force(half, mass, v);
      })},
     {"drags exchanged",
      "The two drags are exchanged: the linear one grows with the speed, the quadratic one with "
      "its square.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) -> Vec3 {
        return mass * s.gravity - s.quadratic_drag * v - s.linear_drag * v.norm() * v;
      })},
     {"drag along the velocity",
      "The drag has the wrong sign: it drives the particles on. It acts against the velocity.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) -> Vec3 {
        return 2 * mass * s.gravity - right_force(s, mass, v);
      })},
     {"squared axis by axis",
      "You have worked out the quadratic drag for each axis by itself, from that axis' part of the "
      "velocity. It is the speed, the length of the whole vector, that counts.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) -> Vec3 {
        return mass * s.gravity - s.linear_drag * v -
               s.quadratic_drag * v.cwiseAbs().cwiseProduct(v);
      })},
     {"square without a direction",
      "You have squared the components of the velocity, which takes their signs away: this drag "
      "pushes towards the negative axes whichever way the particle moves.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) -> Vec3 {
        return mass * s.gravity - s.linear_drag * v - s.quadratic_drag * v.cwiseProduct(v);
      })},
     {"cube of the speed",
      "The quadratic drag grows as the cube of the speed: you have multiplied the square of the "
      "speed by the velocity, which has the speed in it once more.",
      "Forces", with_force([](const System& s, double mass, const Vec3& v) -> Vec3 {
        return mass * s.gravity - s.linear_drag * v - s.quadratic_drag * v.squaredNorm() * v;
      })},
     {"spring pushes",
      "The springs push where they are stretched and pull where they are compressed. A stretched "
      "spring pulls its ends towards each other: look at the direction in which you measure it.",
      "Forces", with_pull([](const Spring& s, const Vec3& l, const Vec3& rate) {
        return opposite(-right_pull(s, l, rate).on_i);
      })},
     {"one end only",
      "Your spring acts on its end i alone. It pulls at both ends: momentum does not come from "
      "nowhere.",
      "Forces", with_pull([](const Spring& s, const Vec3& l, const Vec3& rate) -> Ends {
        return {right_pull(s, l, rate).on_i, Vec3::Zero()};
      })},
     {"both ends the same way",
      "A spring pushes both of its ends in the same direction, so that it could fly off by itself. "
      "The two forces are opposite.",
      "Forces", with_pull([](const Spring& s, const Vec3& l, const Vec3& rate) -> Ends {
        const Vec3 F = right_pull(s, l, rate).on_i;
        return {F, F};
      })},
     {"rest length forgotten",
      "Your springs pull with their whole length. What counts is how much longer than at rest they "
      "are.",
      "Forces", with_pull([](Spring s, const Vec3& l, const Vec3& rate) {
        s.rest_length = 0;
        return right_pull(s, l, rate);
      })},
     {"rest length added",
      "You have added the rest length to the length of a spring. What counts is how much longer "
      "than at rest it is.",
      "Forces", with_pull([](Spring s, const Vec3& l, const Vec3& rate) {
        s.rest_length *= -1;
        return right_pull(s, l, rate);
      })},
     {"stretch as a fraction",
      "You have divided the stretch of the springs by their rest length. The stiffness is in "
      "newtons per metre: it multiplies a length.",
      "Forces", with_pull([](Spring s, const Vec3& l, const Vec3& rate) {
        s.stiffness /= s.rest_length;
        return right_pull(s, l, rate);
      })},
     {"direction not of length 1",
      "You have multiplied the tension of a spring by the whole vector between its ends. A "
      "direction has length 1.",
      "Forces", with_pull([](const Spring& s, const Vec3& l, const Vec3& rate) {
        return opposite(-tension(s, l, rate) * l);
      })},
     {"damped across the spring too",
      "The damping resists all of the ends' motion against each other, also the part perpendicular "
      "to the spring. Only the part along the spring changes its length.",
      "Forces", with_pull([](const Spring& s, const Vec3& l, const Vec3& rate) {
        if (l.isZero(0)) return opposite(Vec3::Zero());
        return opposite(-tension(s, l, Vec3::Zero()) * l.normalized() - s.damping * rate);
      })},
     {"damped by the speed",
      "The damping grows with the speed of the ends against each other, in whatever direction they "
      "move. What counts is the rate at which the spring gets longer; it can be negative.",
      "Forces", with_pull([](const Spring& s, const Vec3& l, const Vec3& rate) {
        return right_pull(s, l, rate.norm() * l.normalized());
      })},
     {"damping only pulls",
      "You have dropped the sign of the rate at which a spring gets longer, so a spring that gets "
      "shorter is pulled together even faster.",
      "Forces", with_pull([](const Spring& s, const Vec3& l, const Vec3& rate) {
        const Vec3 u = l.normalized();
        return right_pull(s, l, std::abs(rate.dot(u)) * u);
      })},
     {"damping drives",
      "The damping has the wrong sign: it helps a spring that gets longer. It should resist.",
      "Forces", with_pull([](const Spring& s, const Vec3& l, const Vec3& rate) {
        return right_pull(s, l, -rate);
      })},
     {"damping forgotten", "The springs are not damped: the rate of their length does not count.",
      "Forces", with_pull([](Spring s, const Vec3& l, const Vec3& rate) {
        s.damping = 0;
        return right_pull(s, l, rate);
      })},
     {"zero over zero",
      "Where both ends of a spring are at the same place, you have divided the vector between them "
      "by its length, which is 0 there.",
      "Forces", with_pull([](const Spring& s, const Vec3& l, const Vec3& rate) {
        const Vec3 u = l / l.norm();
        const double pull = s.stiffness * (l.norm() - s.rest_length) + s.damping * rate.dot(u);
        return opposite(-pull * u);
      })},
     {"damped by one end",
      "You have taken the velocity of one end of the spring for the rate of its length. Both ends "
      "move: their difference counts.",
      "Forces",
      [](const System& system, double, const VectorXd& y) {
        VectorXd ydot = with_laws(system, y, right_force, right_pull);
        for (const Spring& s : system.springs) {
          const Vec3 u = (x_of(y, s.i) - x_of(y, s.j)).normalized();
          const Vec3 missing = s.damping * v_of(y, s.j).dot(u) * u;
          ydot.segment<3>(6 * s.i + 3) -= missing / mass_of(system, s.i);
          ydot.segment<3>(6 * s.j + 3) += missing / mass_of(system, s.j);
        }
        return ydot;
      }},
     {"last force only",
      "The force of a spring has replaced what was there before. Forces add up: weight, drag, and "
      "every spring that ends at the particle.",
      "Forces",
      [](const System& system, double, const VectorXd& y) {
        VectorXd ydot = with_laws(
            {system.masses, system.gravity, system.linear_drag, system.quadratic_drag, {}}, y,
            right_force, right_pull);
        for (const Spring& s : system.springs) {
          const Ends ends = right_pull(s, x_of(y, s.i) - x_of(y, s.j), v_of(y, s.i) - v_of(y, s.j));
          ydot.segment<3>(6 * s.i + 3) = ends.on_i / mass_of(system, s.i);
          ydot.segment<3>(6 * s.j + 3) = ends.on_j / mass_of(system, s.j);
        }
        return ydot;
      }},
     {"halves swapped",
      "ẋ and v̇ are swapped: the rate of the position comes first, as the position does.",
      "The right-hand side",
      [](const System& system, double t, const VectorXd& y) {
        const VectorXd right = reference(system, t, y);
        VectorXd ydot = right;
        for (int n = 0; n < count_of(system); ++n)
          ydot.segment<6>(6 * n) << v_of(right, n), x_of(right, n);
        return ydot;
      }},
     {"velocity in both halves",
      "In the places of v̇ you have the velocities once more. The velocity changes by the "
      "acceleration, "
      "F/m.",
      "The right-hand side",
      [](const System& system, double t, const VectorXd& y) {
        VectorXd ydot = reference(system, t, y);
        for (int n = 0; n < count_of(system); ++n) ydot.segment<3>(6 * n + 3) = v_of(y, n);
        return ydot;
      }},
     {"acceleration in both halves",
      "In the places of ẋ you have the accelerations. The position changes by the velocity.",
      "The right-hand side",
      [](const System& system, double t, const VectorXd& y) {
        VectorXd ydot = reference(system, t, y);
        for (int n = 0; n < count_of(system); ++n) ydot.segment<3>(6 * n) = v_of(ydot, n);
        return ydot;
      }},
     {"mass of the first particle",
      "You have divided every force by the mass of the first particle. Each particle has its own.",
      "The right-hand side",
      [](const System& system, double t, const VectorXd& y) {
        VectorXd ydot = reference(system, t, y);
        for (int n = 0; n < count_of(system); ++n)
          ydot.segment<3>(6 * n + 3) *= mass_of(system, n) / mass_of(system, 0);
        return ydot;
      }},
     {"position for its rate",
      "In the places of ẋ you have the positions themselves. What the solver wants is how fast "
      "they "
      "change.",
      "The right-hand side",
      [](const System& system, double t, const VectorXd& y) {
        VectorXd ydot = reference(system, t, y);
        for (int n = 0; n < count_of(system); ++n) ydot.segment<3>(6 * n) = x_of(y, n);
        return ydot;
      }},
     {"rate added to the state",
      "You have added the state to the result. Return the rate alone; the step is the solver's "
      "business.",
      "The right-hand side",
      [](const System& system, double t, const VectorXd& y) -> VectorXd {
        return y + reference(system, t, y);
      }},
     {"all positions first",
      "You have read the state, and written the rate, as if all positions came before all "
      "velocities. The order is that of flatten: particle after particle.",
      "The state", [](const System& system, double t, const VectorXd& y) {
        return positions_first(reference(system, t, positions_first_undone(y)));
      }}}};
