#include "tumble/mesh/finite_bounds.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"

using namespace tumble;
using namespace tumble::detail;

TEST_CASE("finite_bounds: the box of bounds(), for any number of vertices and all instructions") {
  test::Random rng(51);
  PolygonMesh mesh;
  for (int n = 1; n <= 30; ++n) {
    mesh.vertices.push_back(std::pow(10, rng.uniform(-3, 3)) * rng.vector());
    for (int set = 0; set <= static_cast<int>(simd::best_instruction_set()); ++set) {
      const FiniteBounds found = finite_bounds(mesh, static_cast<simd::InstructionSet>(set));
      CAPTURE(n);
      CHECK(found.finite);
      CHECK(found.box.min() == bounds(mesh).min());
      CHECK(found.box.max() == bounds(mesh).max());
    }
  }
}

TEST_CASE("finite_bounds: sees what is not finite, wherever it is; the largest doubles are") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (std::size_t n = 1; n <= 9; ++n) {
    for (std::size_t i = 0; i < 3 * n; ++i) {
      PolygonMesh mesh;
      mesh.vertices.assign(n, Vec3(1e308, -1e308, 1e308));
      CHECK(finite_bounds(mesh).finite);
      for (const double odd : {std::nan(""), inf, -inf}) {
        mesh.vertices[i / 3][static_cast<Eigen::Index>(i % 3)] = odd;
        CAPTURE(odd);
        CHECK_FALSE(finite_bounds(mesh).finite);
      }
    }
  }
}
