#include "tumble/ensemble/magnus.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/observed_order.hpp"
#include "tumble/quaternion/convert.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/quaternion/quaternion_dot.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::eps;

namespace {

using Coefficients = std::vector<Vec3>;  // of ω: Σ c[k] tᵏ

/// The turn from 0 to h, from q̇ = ½ q ⟨0, ω⟩.
Quat truth(const Coefficients& c, double h) {
  const auto rate = [&](double t, const Eigen::Vector4d& q) -> Eigen::Vector4d {
    Vec3 omega = Vec3::Zero();
    for (std::size_t k = c.size(); k-- > 0;) omega = c[k] + t * omega;
    return coefficients(rotation::quaternion_dot_body(from_coefficients<double>(q), omega));
  };
  const Eigen::Vector4d start(1, 0, 0, 0);
  return from_coefficients<double>(
      integrate_adaptive<Dop853>(rate, start, 0.0, h, {1e-15, 1e-15}).y);
}

template <std::size_t terms>
double error(const Coefficients& c, double h) {
  simd::Point<double> b[terms];
  double power = h;
  for (std::size_t k = 0; k < terms; ++k, power *= h)
    b[k] = {power * c[k].x(), power * c[k].y(), power * c[k].z()};
  const simd::Point<double> turn = ensembles::rotation_vector(b);
  return angle_between(exp_quaternion(Vec3(turn.x, turn.y, turn.z)), truth(c, h));
}

/// Whatever the angular velocity does, one step errs by C h^(N + 1).
template <std::size_t terms>
void check_order(double longest) {
  test::Random rng(651);
  Coefficients c;
  for (std::size_t k = 0; k < terms; ++k) c.push_back(rng.vector());
  std::vector<double> h, errors;
  for (double step = longest; h.size() < 4; step *= 0.75) {
    h.push_back(step);
    errors.push_back(error<terms>(c, step));
  }
  const double order = runge_kutta::observed_order(h, errors);
  MESSAGE(terms << " coefficients: one step errs as h^" << order << ", by " << errors.back());
  CHECK(order >= static_cast<double>(terms) - 0.3);
}

}  // namespace

TEST_CASE("rotation_vector: one step has an error of the order that comes next") {
  check_order<5>(0.4);
  check_order<7>(0.6);
  check_order<9>(0.8);
}

TEST_CASE("rotation_vector: about a fixed axis it is the integral, exactly") {
  const Vec3 axis(1, 2, -2);
  const auto turn = [&]<std::size_t terms>(const double(&w)[terms]) {
    simd::Point<double> b[terms];
    for (std::size_t k = 0; k < terms; ++k)
      b[k] = {w[k] * axis.x(), w[k] * axis.y(), w[k] * axis.z()};
    return ensembles::rotation_vector(b);
  };
  // The last coefficient is left out: it would change the turn by what is neglected anyway.
  CHECK(std::abs(turn({1, 0.5, 0.25, 0.125, 9}).x - (1 + 0.25 + 0.25 / 3 + 0.125 / 4)) <= 8 * eps);
  CHECK(std::abs(turn({1, 0, 0, 0, 0.5, 0.25, 9}).y - 2 * (1 + 0.1 + 0.25 / 6)) <= 8 * eps);
  CHECK(std::abs(turn({1, 0, 0, 0, 0, 0, 0.5, 0.25, 9}).z + 2 * (1 + 0.5 / 7 + 0.25 / 8)) <=
        8 * eps);
}
