#pragma once
/// @file
/// A motion in pieces: at the end of each, something has changed the state at once.

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "tumble/core/largest.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/simulate/first_event.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

/// One simulation and the part of it that counts.
template <class State>
struct Piece {
  TrajectoryOf<State> motion;
  double t0, t1;  ///< [s]

  /// The state after a part of the piece, 0 … 1.
  State at_part(double theta) const {
    return motion.at(std::clamp(t0 + theta * (t1 - t0), t0, t1));
  }
};

template <class State>
class PiecewiseTrajectory final : public AnyTrajectory<State> {
 public:
  explicit PiecewiseTrajectory(std::vector<Piece<State>> pieces) : pieces_(std::move(pieces)) {}

  /// At an event: after it.
  State at(double t) const override {
    const auto after =
        std::upper_bound(pieces_.begin() + 1, pieces_.end(), t,
                         [](double time, const Piece<State>& piece) { return time < piece.t0; });
    return std::prev(after)->motion.at(t);
  }
  std::vector<double> times() const override {
    std::vector<double> all;
    for (const Piece<State>& piece : pieces_) {
      all.push_back(piece.t0);
      for (const double t : piece.motion.times())
        if (t > piece.t0 && t < piece.t1) all.push_back(t);
    }
    all.push_back(pieces_.back().t1);
    return all;
  }

 private:
  std::vector<Piece<State>> pieces_;
};

/// A motion and what has changed it.
template <class State>
struct TrajectoryWithChanges {
  std::vector<Piece<State>> pieces;
  std::vector<EventOf<State>> events;
};

/// The largest |x|, |P| and |L| of a body on the way.
struct Sizes {
  double x = 0, P = 0, L = 0;

  void grow(const RigidBodyState<>& state) {
    x = largest({x, state.x.norm()});
    P = largest({P, state.P.norm()});
    L = largest({L, state.L.norm()});
  }
};

inline double part_of(double off, double size) { return size > 0 ? off / size : off; }

/// The largest difference of two motions with the same events, at the same parts of their pieces:
/// the angle between orientations [rad], and all else a part of its largest size.
template <class State>
double difference_of(const TrajectoryWithChanges<State>& a, const TrajectoryWithChanges<State>& b) {
  constexpr double parts[] = {0, 0.3, 0.7, 1};
  const auto bodies = [](const State& state) {
    if constexpr (std::is_same_v<State, RigidBodyState<>>)
      return std::vector<RigidBodyState<>>{state};
    else
      return state;
  };
  std::vector<Sizes> sizes(bodies(a.pieces.front().at_part(0)).size());
  const auto for_each = [&](const auto& use) {
    for (std::size_t i = 0; i < a.pieces.size(); ++i)
      for (const double theta : parts) {
        const auto left = bodies(a.pieces[i].at_part(theta));
        const auto right = bodies(b.pieces[i].at_part(theta));
        for (std::size_t k = 0; k < left.size(); ++k) use(left[k], right[k], sizes[k]);
      }
  };
  for_each([](const auto& s, const auto&, Sizes& size) { size.grow(s); });
  double most = 0;
  for_each([&](const RigidBodyState<>& s, const RigidBodyState<>& t, const Sizes& size) {
    most = largest({most, angle_between(s.q, t.q), part_of((s.x - t.x).norm(), size.x),
                    part_of((s.P - t.P).norm(), size.P), part_of((s.L - t.L).norm(), size.L)});
  });
  return most;
}

}  // namespace tumble::detail
