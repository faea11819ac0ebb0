#pragma once
/// @file
/// Very many rigid bodies that do not touch each other, to be moved together: see advance().
///
/// Source: the principal axes as in Landau & Lifshitz, "Mechanics" (1976), §32.

#include <optional>
#include <span>
#include <vector>

#include "tumble/body/derived.hpp"
#include "tumble/core/require.hpp"
#include "tumble/ensemble/common_fall.hpp"
#include "tumble/ensemble/eights.hpp"
#include "tumble/ensemble/lost_bodies.hpp"
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
      : size_(bodies.size()), bodies_(eights(size_)), spins_(eights(size_)), paths_(eights(size_)) {
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
    const std::size_t at = i / detail::ensembles::eight;
    const auto& [mass, moments, axes] = bodies_[at];
    const int lane = lane_of(i);
    const Quat turn = quaternion(spins_[at].q, lane);
    const Vec3 L_principal = vector(moments, lane).cwiseProduct(vector(spins_[at].omega, lane));
    return {position(i), (turn * quaternion(axes, lane).conjugate()).normalized(),
            mass[lane] * velocity(i), turn.normalized() * L_principal};
  }

  // For advance() and its kernels.

  /// Structures of eight.
  std::span<const detail::ensembles::EightBodies> bodies() const { return bodies_; }
  /// The paths are those that were written last.
  detail::ensembles::EightMotions motions(std::size_t eight) {
    return {spins_[eight], paths_[eight]};
  }

  /// All centres of mass go on for a time [s] under an acceleration [m/s²]; no path is written.
  void fall(double time, const Vec3& acceleration) {
    if (!extent_) extent_ = detail::ensembles::extent_of(paths_);
    fall_.go_on(time, acceleration);
  }
  /// Writes where they are by now, before each goes its own way.
  void write_paths() {
    extent_.reset();
    if (fall_.is_none()) return;
    for (detail::ensembles::EightPaths& path : paths_) fall_.write_to(path);
    fall_ = {};
  }
  /// The bodies whose motion is not finite, if the fall may have brought any beyond the numbers;
  /// `turning` is what is known of those that do not turn finitely.
  LostBodies lost_by_falling(const LostBodies& turning) const {
    if (extent_ && fall_.stays_finite(*extent_)) return turning;
    LostBodies lost;
    for (std::size_t i = 0; i < size_; ++i)
      if (!is_finite(i)) lost.add(i);
    return lost;
  }

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
    const auto& [spin, path] = motions(i / detail::ensembles::eight);
    const int lane = lane_of(i);
    constants.mass[lane] = body.mass();
    put(I, constants.moments, lane);
    put(coefficients(axes), constants.axes, lane);
    put(coefficients(q), spin.q, lane);
    put(omega, spin.omega, lane);
    put<3>({(I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]}, spin.asymmetry,
           lane);
    put(state.x, path.x, lane);
    put(v, path.v, lane);
  }

  Vec3 position(std::size_t i) const {
    const auto& [x, v] = paths_[i / detail::ensembles::eight];
    const int lane = lane_of(i);
    return {fall_.position(x[0][lane], v[0][lane], 0), fall_.position(x[1][lane], v[1][lane], 1),
            fall_.position(x[2][lane], v[2][lane], 2)};
  }
  Vec3 velocity(std::size_t i) const {
    return vector(paths_[i / detail::ensembles::eight].v, lane_of(i)) + fall_.velocity;
  }
  bool is_finite(std::size_t i) const {
    const auto& spin = spins_[i / detail::ensembles::eight];
    return position(i).allFinite() && velocity(i).allFinite() &&
           quaternion(spin.q, lane_of(i)).coeffs().allFinite() &&
           vector(spin.omega, lane_of(i)).allFinite();
  }
  static Quat unit(std::size_t i, const Quat& q) {
    const double norm = q.coeffs().stableNorm();
    require(norm > 0 && std::isfinite(norm), "body ", i, " of an ensemble: no rotation has the ",
            "quaternion (w x y z) = (", q.w(), ' ', q.x(), ' ', q.y(), ' ', q.z(), ")");
    return rotation::normalize(q);
  }

  std::size_t size_;
  std::vector<detail::ensembles::EightBodies> bodies_;
  std::vector<detail::ensembles::EightSpins> spins_;
  std::vector<detail::ensembles::EightPaths> paths_;
  detail::ensembles::CommonFall fall_;               ///< since the paths were written
  std::optional<detail::ensembles::Extent> extent_;  ///< of the paths as written, if it is known
};

/// @}

}  // namespace tumble
