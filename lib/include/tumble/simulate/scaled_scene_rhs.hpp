#pragma once
/// @file
/// Several bodies and any forces on and between them, each body in the units and axes of
/// ScaledBody. As in ScaledRhs it is forgotten what the forces are.

#include <functional>
#include <vector>

#include "tumble/body/many_bodies.hpp"
#include "tumble/core/largest.hpp"
#include "tumble/simulate/scaled_body.hpp"

namespace tumble::detail {

/// A right-hand side of bodies under forces.
class ScaledSceneRhs {
 public:
  using Numbers = PackedScene<double>;
  using State = std::vector<RigidBodyState<>>;
  static constexpr auto why = "a force acts between bodies";

  /// @param rhs   a SceneRhs<double, …>
  /// @param start of each body
  /// @param t0    the start [s]
  /// @param span  how long they will move [s]
  template <class Rhs>
  ScaledSceneRhs(const Rhs& rhs, const State& start, double t0, double span)
      : unscaled_(rhs.bodies().begin(), rhs.bodies().end()),
        net_([rhs](double t, const std::vector<Derived<>>& now) { return rhs.net(t, now); }) {
    std::vector<Derived<>> now;
    for (std::size_t i = 0; i < start.size(); ++i)
      now.push_back(derived(rhs.bodies()[i], start[i]));
    const std::vector<Wrench<>> net = rhs.net(t0, now);
    for (std::size_t i = 0; i < start.size(); ++i)
      bodies_.emplace_back(rhs.bodies()[i], units_of(rhs.bodies()[i], start[i], net[i], span));
  }

  /// Of the body that has lost the most.
  double lost_moments() const {
    return largest_of([](const ScaledBody& body, Eigen::Index) { return body.lost_moments(); });
  }

  Numbers numbers(const State& states) const {
    Numbers y(size * count());
    for (Eigen::Index i = 0; i < count(); ++i)
      y.segment<size>(size * i) = body(i).numbers(states[static_cast<std::size_t>(i)]);
    return y;
  }

  State state(const Numbers& y) const {
    State states;
    for (Eigen::Index i = 0; i < count(); ++i) states.push_back(body(i).state(part(y, i)));
    return states;
  }

  /// |ω| of the body that turns fastest [rad/s].
  double omega(const Numbers& y) const {
    return largest_of(
        [&](const ScaledBody& body, Eigen::Index i) { return body.omega(part(y, i)); });
  }

  /// The squares of the sizes that are too small to matter in a span of time, four for each body.
  SquaredSizes<Numbers> least_squares(double span) const {
    SquaredSizes<Numbers> squares(4 * count());
    for (Eigen::Index i = 0; i < count(); ++i)
      squares.segment<4>(4 * i) =
          body(i).squares(least_sizes(unscaled_[static_cast<std::size_t>(i)], span));
    return squares;
  }

  /// All that the forces may depend on, but the time.
  std::vector<Derived<>> motion(const Numbers& y) const {
    std::vector<Derived<>> now;
    for (Eigen::Index i = 0; i < count(); ++i) now.push_back(body(i).moving(part(y, i)).now);
    return now;
  }
  std::vector<Wrench<>> net(double t, const std::vector<Derived<>>& now) const {
    return net_(t, now);
  }

  /// dy/dt at time t [s].
  Numbers operator()(double t, const Numbers& y) const {
    std::vector<ScaledBody::Moving> moving;
    std::vector<Derived<>> now;
    for (Eigen::Index i = 0; i < count(); ++i) {
      moving.push_back(body(i).moving(part(y, i)));
      now.push_back(moving.back().now);
    }
    const std::vector<Wrench<>> net = net_(t, now);
    Numbers rate(y.size());
    for (Eigen::Index i = 0; i < count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      rate.segment<size>(size * i) = body(i).rate(part(y, i), moving[at], net[at]);
    }
    return rate;
  }

 private:
  static constexpr int size = rigid_body_state_size;

  Eigen::Index count() const { return static_cast<Eigen::Index>(bodies_.size()); }
  const ScaledBody& body(Eigen::Index i) const { return bodies_[static_cast<std::size_t>(i)]; }
  static ScaledBody::Numbers part(const Numbers& y, Eigen::Index i) {
    return y.segment<size>(size * i);
  }

  /// @param number number(body, i)
  template <class Number>
  double largest_of(const Number& number) const {
    double most = 0;
    for (Eigen::Index i = 0; i < count(); ++i) most = largest({most, number(body(i), i)});
    return most;
  }

  std::vector<RigidBody<>> unscaled_;
  std::function<std::vector<Wrench<>>(double, const std::vector<Derived<>>&)> net_;
  std::vector<ScaledBody> bodies_;
};

}  // namespace tumble::detail
