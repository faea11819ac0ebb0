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

/// Of the points of a contact, along its normal.
struct Speeds {
  Vec3 normal;
  double coming;   ///< the fastest before the impulses [m/s]
  double parting;  ///< the slowest after them [m/s]
};

/// How a body has landed since it stood or rolled.
struct Landings {
  double fastest = 0;  ///< the largest speed [m/s]
  int faint = 0;       ///< how many in turn had next to no speed
  bool skids = false;  ///< of a ball: whether its bounces have ended, and it slides on in hops

  /// Counts a landing.
  /// @param lowest speed of a hop [m/s]
  void count(double coming, double lowest) {
    fastest = std::max(fastest, coming);
    faint = coming <= 1e-2 * lowest ? faint + 1 : 0;
  }
};

/// How fast a body leaves the ground for a hop of some height.
inline double hop_speed(double pull, double height) { return std::sqrt(2 * pull * height); }

/// Lets a body leave the ground with the speed of the lowest hop, if it leaves more slowly. It
/// keeps its energy: motions with which the middle of the contact does not part are slowed as a
/// whole. So this is a rolling resistance, and it takes no more than the energy of a hop each time.
/// Nothing happens if the body has not twice as much.
/// @param points of the contact, from the centre, in world axes [m]
/// @param lowest speed [m/s]
/// @return whether it was lifted
inline bool lift_to_hop(Colliding& a, const collide::ContactPoints& points, const Vec3& normal,
                        double lowest) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& arm : points) middle += arm / static_cast<double>(points.size());
  const Touching touching(a, nullptr);
  const double ease = normal.dot(touching.K(middle) * normal);
  const double parting = normal.dot(touching.velocity(middle));
  // A motion is that of an impulse along the normal, and one that has no speed there: their
  // energies add up.
  const double missing = (lowest * lowest - parting * parting) / (2 * ease);
  const double other = kinetic_energy(a.body, a.state) - parting * parting / (2 * ease);
  if (parting >= lowest || other < 2 * missing) return false;
  const double slower = std::sqrt(1 - missing / other);
  const Vec3 impulse = (lowest - slower * parting) / ease * normal;
  a.state.P = slower * a.state.P + impulse;
  a.state.L = slower * a.state.L + middle.cross(impulse);
  return true;
}

}  // namespace tumble::contact::detail
