#include "tumble/particles/flatten.hpp"

#include <doctest/doctest.h>

#include <string>

#include "project/harness/inputs.hpp"

using namespace tumble;

namespace {

const std::vector<particles::Particle<>> two{{2, {1, 2, 3}, {4, 5, 6}},
                                             {3, {7, 8, 9}, {10, 11, 12}}};

}  // namespace

TEST_CASE("flatten: a worked number, x1 v1 x2 v2") {
  CHECK(particles::flatten(two) == Eigen::VectorXd::LinSpaced(12, 1, 12));
}

TEST_CASE("flatten: fixed size from an array, dynamic from a vector or a span") {
  const std::array<particles::Particle<float>, 2> fixed{
      particles::Particle<float>{2, {1, 2, 3}, {4, 5, 6}},
      particles::Particle<float>{3, {7, 8, 9}, {10, 11, 12}}};
  const auto y = particles::flatten(fixed);
  static_assert(decltype(y)::RowsAtCompileTime == 12);
  CHECK(y == Eigen::VectorXf::LinSpaced(12, 1, 12));
  const std::span<const particles::Particle<>> second(two.data() + 1, 1);
  CHECK(particles::flatten(second) == Eigen::VectorXd::LinSpaced(6, 7, 12));
  CHECK(particles::flatten(std::vector<particles::Particle<>>()).size() == 0);
  CHECK(particles::flatten(std::array<particles::Particle<>, 1>{two[0]}) ==
        Eigen::VectorXd::LinSpaced(6, 1, 6));
}

TEST_CASE("unflatten: takes back what flatten did, and keeps the masses") {
  test::Random rng(91);
  for (int n = 1; n <= 50; ++n) {
    CAPTURE(n);
    std::vector<particles::Particle<>> particles, others;
    for (int i = 0; i < n; ++i) {
      particles.push_back({rng.uniform(1, 2), rng.vector(), rng.vector()});
      others.push_back({rng.uniform(3, 4), rng.vector(), rng.vector()});
    }
    const std::vector<particles::Particle<>> back =
        particles::unflatten(particles::flatten(particles), others);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      CHECK(back[i].x == particles[i].x);
      CHECK(back[i].v == particles[i].v);
      CHECK(back[i].mass == others[i].mass);
    }
  }
}

TEST_CASE("unflatten: refuses a state of another size") {
  for (const int size : {0, 6, 11, 13}) {
    std::string message;
    try {
      particles::unflatten(Eigen::VectorXd::Zero(size), two);
    } catch (const std::invalid_argument& e) {
      message = e.what();
    }
    const std::string expected = "a state of " + std::to_string(size) + " numbers for 2 particles";
    CHECK(message.find(expected) != std::string::npos);
  }
}
