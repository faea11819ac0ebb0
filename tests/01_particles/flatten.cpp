/// @file
/// 1.1 flatten: its laws, and what goes wrong.
#include "tumble/particles/flatten.hpp"

#include "01_particles/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using Eigen::VectorXd;
using particles::Particle;
using tumble::Vec3;

namespace student {
const Function<decltype(particles::flatten)> flatten{TUMBLE_UNIT};
}

namespace {

using Particles = std::vector<Particle>;

Particle any_particle(double size = 10) {
  return {any_number(0.1, 5), any_vector(size), any_vector(size)};
}

Particles any_particles(int count, double size = 10) {
  Particles list;
  for (int n = 0; n < count; ++n) list.push_back(any_particle(size));
  return list;
}

VectorXd reference(const Particles& list) {
  std::vector<tumble::particles::Particle<double>> same;
  for (const auto& [mass, x, v] : list) same.push_back({mass, x, v});
  return tumble::particles::flatten(same);
}

/// Where particle n starts, as a place and as a number of particles before it.
Eigen::Index start_of(std::size_t n) { return 6 * static_cast<Eigen::Index>(n); }
Eigen::Index count_of(const Particles& list) { return static_cast<Eigen::Index>(list.size()); }

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  // Numbers are only moved: nothing may be rounded.

  TEST_CASE("of any particles: position, then velocity, particle after particle") {
    for (const int count : {2, 3, 4, 7, 12}) {
      const Particles list = any_particles(count);
      REQUIRE(student::flatten(list) == close_to(reference(list), 0));
    }
  }

  TEST_CASE("two particles whose numbers count from 1 to 12 give 1, 2, 3 … 12") {
    const Particles list{{50, {1, 2, 3}, {4, 5, 6}}, {70, {7, 8, 9}, {10, 11, 12}}};
    REQUIRE(student::flatten(list) == close_to(VectorXd(VectorXd::LinSpaced(12, 1, 12)), 0));
  }

  TEST_CASE("the numbers of particle n begin at place 6 n: its position, then its velocity") {
    const Particles list = any_particles(9);
    const auto y = student::flatten(list);
    REQUIRE(y == obeys("there are six numbers per particle",
                       std::abs(static_cast<double>(y->size() - 6 * count_of(list))), 0));
    for (std::size_t n = 0; n < list.size(); ++n) {
      const Vec3 x = y->segment<3>(start_of(n)), v = y->segment<3>(start_of(n) + 3);
      REQUIRE(y ==
              obeys("the position of each particle is found again", (x - list[n].x).norm(), 0));
      REQUIRE(y ==
              obeys("the velocity of each particle is found again", (v - list[n].v).norm(), 0));
    }
  }

  TEST_CASE(
      "whatever the masses, tiny or huge: the same positions and velocities in their places") {
    Particles list = any_particles(3);
    const VectorXd expected = reference(list);
    for (const double mass : {1., 1e-30, 1e30}) {
      for (Particle& particle : list) particle.mass = mass;
      REQUIRE(student::flatten(list) == close_to(expected, 0));
    }
  }

  TEST_CASE("one particle is six numbers, its position first; no particle is none") {
    const Particles one = any_particles(1), none;
    REQUIRE(student::flatten(one) == close_to(reference(one), 0));
    REQUIRE(student::flatten(none) == close_to(VectorXd(0), 0));
  }

  TEST_CASE("particles at rest, at the origin, tiny and huge numbers, all as they are") {
    for (const double size : {0., 1e-300, 1e-9, 1e300}) {
      const Particles list = any_particles(3, size);
      REQUIRE(student::flatten(list) == close_to(reference(list), 0));
    }
    const Vec3 x = any_vector();
    const Particles still{{1, x, Vec3::Zero()}, {1, Vec3::Zero(), x}, {1, x, Vec3::Zero()}};
    REQUIRE(student::flatten(still) == close_to(reference(still), 0));
  }

  TEST_CASE("a cloud of 500 particles") {
    const Particles list = any_particles(500);
    REQUIRE(student::flatten(list) == close_to(reference(list), 0));
  }
}

const Misconceptions<decltype(particles::flatten)> misconceptions{
    TUMBLE_UNIT,
    {{"all positions first",
      "All positions come before all velocities. In our state a particle's numbers stay together: "
      "its velocity follows its own position.",
      "The state",
      [](const Particles& list) {
        VectorXd y(6 * count_of(list));
        for (Eigen::Index n = 0; n < count_of(list); ++n) {
          y.segment<3>(3 * n) = list[static_cast<std::size_t>(n)].x;
          y.segment<3>(3 * (count_of(list) + n)) = list[static_cast<std::size_t>(n)].v;
        }
        return y;
      }},
     {"velocity first",
      "Each particle's velocity comes before its position. The order of the state is x, then v.",
      "The state",
      [](const Particles& list) {
        Particles swapped = list;
        for (Particle& particle : swapped) particle.x.swap(particle.v);
        return reference(swapped);
      }},
     {"axis by axis",
      "Position and velocity alternate, axis by axis: x, v_x, y, v_y, z, v_z. The three numbers of "
      "a vector stay together.",
      "The state",
      [](const Particles& list) -> VectorXd {
        VectorXd y = reference(list);
        for (Eigen::Index n = 0; n < count_of(list); ++n) {
          const Eigen::Matrix<double, 3, 2> columns = y.segment<6>(6 * n).reshaped(3, 2);
          y.segment<6>(6 * n) = columns.transpose().reshaped();
        }
        return y;
      }},
     {"momentum for velocity",
      "In the places of the velocities you have momenta: you have multiplied the velocities by the "
      "masses. We will store rigid bodies like this, but not particles.",
      "The state",
      [](const Particles& list) {
        Particles heavy = list;
        for (Particle& particle : heavy) particle.v *= particle.mass;
        return reference(heavy);
      }},
     {"masses stored too",
      "There are seven numbers per particle, the mass among them. A mass does not change: it "
      "belongs "
      "to the system, not to the state.",
      "The state",
      [](const Particles& list) {
        VectorXd y(7 * count_of(list));
        for (Eigen::Index n = 0; n < count_of(list); ++n) {
          const auto& [mass, x, v] = list[static_cast<std::size_t>(n)];
          y.segment<7>(7 * n) << mass, x, v;
        }
        return y;
      }},
     {"three places a particle",
      "The next particle starts three places later, on top of the velocity of the one before. A "
      "particle takes six places.",
      "The state",
      [](const Particles& list) {
        VectorXd y = VectorXd::Zero(6 * count_of(list));
        for (Eigen::Index n = 0; n < count_of(list); ++n)
          y.segment<6>(3 * n) << list[static_cast<std::size_t>(n)].x,
              list[static_cast<std::size_t>(n)].v;
        return y;
      }},
     {"velocities left out",
      "Only the positions are there. Where a particle will be next also depends on how fast it is "
      "now: the velocity is part of the state.",
      "The state",
      [](const Particles& list) {
        VectorXd y(3 * count_of(list));
        for (Eigen::Index n = 0; n < count_of(list); ++n)
          y.segment<3>(3 * n) = list[static_cast<std::size_t>(n)].x;
        return y;
      }},
     {"position twice",
      "In the places of the velocities you have the positions once more. A copied line?",
      "The state",
      [](const Particles& list) {
        Particles copies = list;
        for (auto& particle : copies) particle.v = particle.x;
        return reference(copies);
      }},
     {"velocity twice",
      "In the places of the positions you have the velocities once more. A copied line?",
      "The state",
      [](const Particles& list) {
        Particles copies = list;
        for (auto& particle : copies) particle.x = particle.v;
        return reference(copies);
      }},
     {"last particle forgotten",
      "The numbers of the last particle are missing. Look at where the loop ends.", "The state",
      [](const Particles& list) {
        Particles fewer = list;
        if (!fewer.empty()) fewer.pop_back();
        return reference(fewer);
      }},
     {"last particle first",
      "The particles come in the opposite order: the first one of the list comes first.",
      "The state",
      [](const Particles& list) { return reference(Particles(list.rbegin(), list.rend())); }}}};
