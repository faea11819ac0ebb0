#pragma once
/// @file
/// Very many rigid bodies that do not touch each other, to be moved together: see advance().
///
/// Source: the principal axes as in Landau & Lifshitz, "Mechanics" (1976), §32.

#include <span>
#include <vector>

#include "tumble/body/derived.hpp"
#include "tumble/core/require.hpp"
#include "tumble/ensemble/eights.hpp"
#include "tumble/mass/principal_axes.hpp"
#include "tumble/quaternion/normalize.hpp"

namespace tumble {

/// @addtogroup ensemble
/// @{

/// The bodies, in the order in which they were given. What happens to one of them does not depend
/// on the others, to the last bit.
class Ensemble {
 public:
  /// @param states one for each body; their quaternions need not be of length 1
  /// @throws std::invalid_argument if there are not as many states as bodies, or a state is not
  ///         finite or stands for no rotation; the message says which
  Ensemble(std::span<const RigidBody<>> bodies, std::span<const RigidBodyState<>> states)
      : size_(bodies.size()), bodies_(eights(size_)), kinematics_(eights(size_)) {
    require(bodies.size() == states.size(), "an ensemble of ", bodies.size(), " bodies has ",
            states.size(), " states");
    for (std::size_t i = 0; i < size_; ++i) set(i, bodies[i], states[i]);
    for (std::size_t i = size_; i < detail::ensembles::eight * bodies_.size(); ++i)
      set(i, RigidBody<>(1, Mat3::Identity()), {});  // lanes without a body
  }

  std::size_t size() const { return size_; }

  /// Where body i is now, in its own axes again, and its momenta.
  /// @throws std::invalid_argument if there is no body i
  TUMBLE_ONE_COPY RigidBodyState<> state(std::size_t i) const {
    require(i < size_, "there is no body ", i, " in an ensemble of ", size_);
    const auto& [x, v, q, omega] = kinematics_[i / detail::ensembles::eight];
    const auto& [mass, moments, asymmetry, axes] = bodies_[i / detail::ensembles::eight];
    const int lane = lane_of(i);
    const Quat turn = quaternion(q, lane);
    const Vec3 L_principal = vector(moments, lane).cwiseProduct(vector(omega, lane));
    return {vector(x, lane), (turn * quaternion(axes, lane).conjugate()).normalized(),
            mass[lane] * vector(v, lane), turn.normalized() * L_principal};
  }

  /// The structures of eight, for kernels.
  std::span<const detail::ensembles::EightBodies> bodies() const { return bodies_; }
  std::span<detail::ensembles::EightKinematics> kinematics() { return kinematics_; }

 private:
  static std::size_t eights(std::size_t n) {
    return (n + detail::ensembles::eight - 1) / detail::ensembles::eight;
  }
  static int lane_of(std::size_t i) { return static_cast<int>(i % detail::ensembles::eight); }

  static Vec3 vector(const detail::ensembles::Row (&rows)[3], int lane) {
    return {rows[0][lane], rows[1][lane], rows[2][lane]};
  }
  static Quat quaternion(const detail::ensembles::Row (&rows)[4], int lane) {
    return {rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane]};
  }
  template <std::size_t n>
  static void put(const Eigen::Matrix<double, int{n}, 1>& numbers,
                  detail::ensembles::Row (&rows)[n], int lane) {
    for (std::size_t k = 0; k < n; ++k) rows[k][lane] = numbers[static_cast<int>(k)];
  }

  TUMBLE_ONE_COPY void set(std::size_t i, const RigidBody<>& body, const RigidBodyState<>& state) {
    const PrincipalAxes principal = principal_axes(body.I_body());
    const Vec3& I = principal.moments;
    const Quat axes = from_matrix(principal.R), q = unit(i, state.q) * axes;
    const Vec3 v = state.P / body.mass(), omega = (q.conjugate() * state.L).cwiseQuotient(I);
    require(state.x.allFinite() && v.allFinite() && omega.allFinite(), "body ", i, " of an ",
            "ensemble: x = (", state.x.transpose(), "), v = (", v.transpose(), "), omega = (",
            omega.transpose(), ") about its principal axes is not finite");
    auto& constants = bodies_[i / detail::ensembles::eight];
    auto& kinematics = kinematics_[i / detail::ensembles::eight];
    const int lane = lane_of(i);
    constants.mass[lane] = body.mass();
    put(I, constants.moments, lane);
    put<3>({(I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]}, constants.asymmetry,
           lane);
    put(coefficients(axes), constants.axes, lane);
    put(state.x, kinematics.x, lane);
    put(v, kinematics.v, lane);
    put(coefficients(q), kinematics.q, lane);
    put(omega, kinematics.omega, lane);
  }

  static Quat unit(std::size_t i, const Quat& q) {
    const double norm = q.coeffs().stableNorm();
    require(norm > 0 && std::isfinite(norm), "body ", i, " of an ensemble: no rotation has the ",
            "quaternion (w x y z) = (", q.w(), ' ', q.x(), ' ', q.y(), ' ', q.z(), ")");
    return rotation::normalize(q);
  }

  std::size_t size_;
  std::vector<detail::ensembles::EightBodies> bodies_;
  std::vector<detail::ensembles::EightKinematics> kinematics_;
};

/// @}

}  // namespace tumble
