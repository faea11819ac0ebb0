// Is every bound a bound? Where all terms of a sum are equal its roundings all point the same way,
// so that they add up as the worst case does: regular cubes, tori, spheres, as they are and turned,
// with every set of instructions that the processor has.
#include <doctest/doctest.h>

#include <cmath>

#include "project/library/mass/meshes.hpp"

using namespace tumble;
using test::Random;

namespace {

/// How often a bound did not hold, and the largest error in units of what it was bounded by.
struct Tally {
  int bodies = 0, broken = 0;
  double worst = 0, worst_mass = 0, worst_inertia = 0;

  void add(const BoundedMassProperties& found, const PolygonMesh& mesh) {
    using T = simd::DoubleDouble;
    const Vec3 p = detail::reference_point(mesh);
    const Moments<T> exact = test::exact_moments(mesh, p);
    const MassProperties truth = mass_properties(exact, p, 1);
    const double mass = std::abs(double((T(found.mass) - exact.one) / exact.one));
    const double inertia = test::inertia_error(found.inertia, truth.inertia);
    const Vector3<T> centre = detail::centre_from_reference(exact) + p.cast<T>();
    const Vector3<T> c = found.centre.cast<T>() + found.centre_rest.cast<T>() - centre;
    // The truth of the inertia is itself rounded: ε.
    const double ratio =
        std::max({mass / found.mass_error_bound, inertia / (found.inertia_error_bound + test::eps),
                  detail::to_double(c).norm() / found.centre_error_bound});
    ++bodies;
    broken += !(ratio <= 1);
    worst = std::max(worst, ratio);
    worst_mass = std::max(worst_mass, mass);
    worst_inertia = std::max(worst_inertia, inertia);
  }
};

/// A length of 44 random bits, as measured ones have.
double random_length(Random& random) { return std::round(random.uniform(1, 2) * 0x1p43) * 0x1p-43; }

/// The tally over bodies that `make` draws.
template <class Make>
Tally tally(simd::InstructionSet set, Accuracy accuracy, int bodies, const Make& make) {
  Tally all;
  Random random(7);
  for (int i = 0; i < bodies; ++i) {
    const PolygonMesh mesh = make(random);
    all.add(unchecked_mass_properties(mesh, 1, accuracy, {.instructions = set}), mesh);
  }
  return all;
}

PolygonMesh any_cube(Random& random) {
  return test::regular_cube(static_cast<int>(random.uniform(2, 25)), random_length(random));
}
PolygonMesh any_torus(Random& random) {
  const int n = static_cast<int>(random.uniform(8, 80)),
            k = static_cast<int>(random.uniform(6, 30));
  return test::triangulated(
      test::torus_mesh(n, k, random_length(random), random_length(random) / 2));
}
PolygonMesh any_sphere(Random& random) {
  return test::moved(test::sphere(static_cast<int>(random.uniform(0, 5))), random_length(random),
                     Vec3::Zero());
}
PolygonMesh turned_cube(Random& random) {
  const PolygonMesh cube = any_cube(random);
  return test::mapped(cube, random.rotation().toRotationMatrix(), random.vector());
}

void check(PolygonMesh (*make)(Random&), int bodies) {
  for (int i = 0; i <= static_cast<int>(simd::best_instruction_set()); ++i)
    for (const Accuracy accuracy : {Accuracy::fast, Accuracy::tight}) {
      const Tally all = tally(static_cast<simd::InstructionSet>(i), accuracy, bodies, make);
      CAPTURE(i);
      CAPTURE(accuracy);
      CHECK(all.broken == 0);
      CHECK(all.worst <= 1);
      CHECK(all.worst_mass <= 1e-15);
      CHECK(all.worst_inertia <= 1e-15);
    }
}

}  // namespace

TEST_CASE("rounding bounds hold on regular cubes of any size") { check(any_cube, 60); }
TEST_CASE("rounding bounds hold on regular cubes that lie askew") { check(turned_cube, 40); }
TEST_CASE("rounding bounds hold on tori") { check(any_torus, 40); }
TEST_CASE("rounding bounds hold on spheres") { check(any_sphere, 20); }
