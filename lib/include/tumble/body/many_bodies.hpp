#pragma once
/// @file
/// Many rigid bodies in one state vector: thirteen numbers each, body after body.
///
/// A scene's forces may act on each body by itself (BodyForce) or between bodies (SceneForce).
/// Source: Baraff, "Rigid Body Simulation I" (1997), §4, ddt_State_to_Array over all bodies.

#include <concepts>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "tumble/body/derived.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/body/state.hpp"
#include "tumble/core/require.hpp"
#include "tumble/quaternion/quaternion_dot.hpp"

namespace tumble {

/// @addtogroup body
/// @{

namespace detail {

template <class T>
using PackedScene = Eigen::Matrix<T, Eigen::Dynamic, 1>;

/// A callable (t, bodies, motions, wrenches) that adds to the wrench of each body it acts on.
template <class F, class T>
concept SceneForce = std::invocable<const F&, T, std::span<const RigidBody<T>>,
                                    std::span<const Derived<T>>, std::span<Wrench<T>>>;

}  // namespace detail

/// All states one after the other, 13 numbers each.
template <class T>
detail::PackedScene<T> pack(const std::vector<RigidBodyState<T>>& states) {
  detail::PackedScene<T> y(detail::rigid_body_state_size *
                           static_cast<Eigen::Index>(states.size()));
  for (std::size_t i = 0; i < states.size(); ++i)
    y.template segment<detail::rigid_body_state_size>(
        detail::rigid_body_state_size * static_cast<Eigen::Index>(i)) = pack(states[i]);
  return y;
}

/// The inverse of pack().
/// @throws std::invalid_argument if the length is not a multiple of 13
template <class T>
std::vector<RigidBodyState<T>> unpack(const detail::PackedScene<T>& y) {
  require(y.size() % detail::rigid_body_state_size == 0, "a scene of rigid bodies has ",
          detail::rigid_body_state_size, " numbers each; ", y.size(), " is not a multiple");
  std::vector<RigidBodyState<T>> states;
  for (Eigen::Index i = 0; i < y.size(); i += detail::rigid_body_state_size)
    states.push_back(
        unpack<T>(PackedState<T>(y.template segment<detail::rigid_body_state_size>(i))));
  return states;
}

/// Bodies and the forces on and between them, as a right-hand side for the solvers in ode/.
template <class T, class... Forces>
requires((BodyForce<Forces, T> || detail::SceneForce<Forces, T>)&&...) class SceneRhs {
 public:
  /// @throws std::invalid_argument if a force refuses what it was made of
  explicit SceneRhs(std::vector<RigidBody<T>> bodies, const Forces&... forces)
      : bodies_(std::move(bodies)), forces_(detail::valid_forces(forces...)) {}

  const std::vector<RigidBody<T>>& bodies() const { return bodies_; }

  /// dy/dt of all packed states at time t [s].
  /// @throws std::invalid_argument if y does not hold 13 numbers for each body
  detail::PackedScene<T> operator()(T t, const detail::PackedScene<T>& y) const {
    std::vector<RigidBodyState<T>> states = unpack<T>(y);
    require(states.size() == bodies_.size(), "the scene has ", bodies_.size(),
            " bodies, the state ", states.size());
    std::vector<Derived<T>> now;
    for (std::size_t i = 0; i < bodies_.size(); ++i) now.push_back(derived(bodies_[i], states[i]));
    const std::vector<Wrench<T>> wrenches = net(t, now);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      states[i] = {now[i].v, rotation::quaternion_dot(states[i].q, now[i].omega), wrenches[i].force,
                   wrenches[i].torque};
    return pack(states);
  }

  /// What all forces do to each body.
  std::vector<Wrench<T>> net(T t, const std::vector<Derived<T>>& now) const {
    std::vector<Wrench<T>> wrenches(bodies_.size());
    std::apply([&](const Forces&... force) { (add(force, t, now, wrenches), ...); }, forces_);
    return wrenches;
  }

 private:
  template <class Force>
  void add(const Force& force, T t, const std::vector<Derived<T>>& now,
           std::vector<Wrench<T>>& net) const {
    if constexpr (BodyForce<Force, T>) {
      for (std::size_t i = 0; i < bodies_.size(); ++i) net[i] += force(t, bodies_[i], now[i]);
    } else {
      force(t, std::span<const RigidBody<T>>(bodies_), std::span<const Derived<T>>(now),
            std::span<Wrench<T>>(net));
    }
  }

  std::vector<RigidBody<T>> bodies_;
  std::tuple<Forces...> forces_;
};

template <class T, class... Forces>
SceneRhs(std::vector<RigidBody<T>>, const Forces&...) -> SceneRhs<T, Forces...>;

/// @}

}  // namespace tumble
