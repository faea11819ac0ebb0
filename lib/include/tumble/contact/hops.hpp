#pragma once
/// @file
/// Contact that lasts, as a train of hops, too low to matter.
///
/// A body that tips over an edge, or turns about a corner, stays in touch while it moves on. Here
/// it hops: slow impacts get a larger e, up to 1, so that hops do not become lower. That creates no
/// energy, and friction acts in each hop. But a point that sticks takes a hop's energy into the
/// body's turning, hop by hop; lift_to_hop() brings it back. Source: Mirtich, "Impulse-based
/// Dynamic Simulation of Rigid Body Systems", PhD thesis, Berkeley (1996), §3.6, "microcollisions".

#include <algorithm>
#include <cmath>

#include "tumble/contact/several_points.hpp"

namespace tumble::contact::detail {

/// How a body has landed since it stood or rolled.
struct Landings {
  double fastest = 0;  ///< the largest speed [m/s]
  int faint = 0;       ///< how many in turn had next to no speed, while the body gained no energy
  double energy = 0;   ///< the largest after one of these [J]
  bool skids = false;  ///< of a ball: whether its bounces have ended, and it slides on in hops
  int close = 0;       ///< how many in turn, where nothing carries it, were too slow to leave

  /// Counts a landing. What begins to slide or to tip gains energy from one to the next.
  /// @param lowest speed of a hop [m/s]
  /// @param now    kinetic energy after it [J]
  void count(double coming, double lowest, double now) {
    fastest = std::max(fastest, coming);
    const bool is_faint = coming <= 1e-2 * lowest, gains = now > energy;
    faint = is_faint && !gains ? faint + 1 : 0;
    energy = is_faint ? std::max(energy, now) : 0;
  }
  /// Whether no hop goes on.
  bool have_ended() const { return faint >= 30; }
  /// Whether these are more than hops need to grow, or bounces to die away: each of them leaves e
  /// of the speed.
  bool are_endless(double e, bool hops) const {
    return faint >= (hops ? 1000 : 1000 / (1 - std::min(e, 0.999999)));
  }
  /// Counts a landing on what may not carry it.
  void count_close(bool is_close) { close = is_close ? close + 1 : 0; }
  /// Whether it stays in touch there, even if it gains speed elsewhere: bounces have lost thirteen
  /// digits, or a thousand have been too low to leave.
  bool stay_close(double e) const { return close >= 30 / std::max(1 - e, 0.03); }
};

/// How fast a body leaves the ground for a hop of some height.
inline double hop_speed(double pull, double height) { return std::sqrt(2 * pull * height); }

/// Lets a body leave the ground with the speed of the lowest hop, if it leaves more slowly. It
/// keeps its energy: motions with which the middle of the contact does not part are slowed as a
/// whole. So this is a rolling resistance, and it takes no more than the energy of a hop each time.
/// A body that has less than three times as much, as at the start on a slope, hops lower.
/// @param points of the contact, from the centre, in world axes [m]
/// @param lowest speed [m/s]
/// @return whether it was lifted
bool lift_to_hop(Colliding& a, const collide::ContactPoints& points, const Vec3& normal,
                 double lowest);

}  // namespace tumble::contact::detail

#ifndef TUMBLE_COMPILED
#include "tumble/contact/hops.inl"
#endif
