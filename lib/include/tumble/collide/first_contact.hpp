#pragma once
/// @file
/// When two things first touch, from any gap between them with a bound on how fast it changes.
///
/// Conservative advancement: what is d apart and comes together with `speed` at most cannot touch
/// before the time d/speed from now. Source: Mirtich, "Impulse-based Dynamic Simulation of Rigid
/// Body Systems", PhD thesis, Berkeley (1996), §2.3.

#include <cmath>

#include "tumble/core/require.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// When two things first touch, and what it took to find it.
struct FirstContact {
  bool found = false;  ///< whether they touch at all
  double t = 0;        ///< when; without a contact, the end of the search [s]
  double gap = 0;      ///< then [m]
  int queries = 0;     ///< how often the gap was asked for
};

/// The first time s ≥ 0 at which h + v s + a s²/2 is 0, for an h that is positive or 0: when what
/// is h above a floor lands. What starts on the floor and leaves it lands when it comes back.
/// Computed without the difference of two numbers that nearly cancel.
/// @param h height [m]; what rounding made negative counts as 0
/// @param v [m/s], @param a [m/s²], negative downwards
/// @return [s], infinity if it never lands
double landing_time(double h, double v, double a);

/// The first time at which a gap is no larger than the tolerance, of those that are looked at;
/// before it the gap is nowhere below 0.
/// @param gap       gap(t) [m]
/// @param speed     bound on |d gap/dt| [m/s], positive
/// @param t0, t1    from when to when [s]
/// @param tolerance [m], positive
/// @throws std::invalid_argument if t1 < t0, speed or tolerance is not positive, or a gap is NaN
template <class Gap>
FirstContact first_contact(const Gap& gap, double speed, double t0, double t1, double tolerance) {
  require(speed > 0 && std::isfinite(speed), "first_contact: the speed ", speed,
          " m/s is not positive and finite");
  require(tolerance > 0, "first_contact: the tolerance ", tolerance, " m is not positive");
  require(t0 <= t1 && std::isfinite(t1 - t0), "first_contact: from t0 = ", t0, " to t1 = ", t1,
          " is not a span of time: t1 must be finite, and not before t0");
  FirstContact contact{.t = t0};
  while (true) {
    contact.gap = gap(contact.t);
    ++contact.queries;
    require(!std::isnan(contact.gap), "first_contact: the gap at t = ", contact.t, " is NaN");
    contact.found = contact.gap <= tolerance;
    const double next = contact.t + contact.gap / speed;
    if (contact.found || contact.t == t1) return contact;
    if (next == contact.t) {  // nearer than t has digits for
      contact.found = true;
      return contact;
    }
    if (next > t1) {
      contact.t = t1;
      return contact;
    }
    contact.t = next;
  }
}

/// @}

}  // namespace tumble::collide

#ifndef TUMBLE_COMPILED
#include "tumble/collide/first_contact.inl"
#endif
