#pragma once
/// @file
/// What forces do to the bodies of a Pack, made ready for many steps: a kernel each.
///
/// A step takes the time 1 and b = h ω: the spin's equation is b′ = diag(asymmetry) (b_y b_z,
/// b_z b_x, b_x b_y) + h² I⁻¹ τ about the principal axes. A kernel adds the last term, at a
/// moment or as a Taylor series over a step.
/// Source: Euler's equations, Landau & Lifshitz, "Mechanics" (1976), §36.

#include "tumble/ensemble/drift.hpp"
#include "tumble/ensemble/force_of.hpp"
#include "tumble/ensemble/pack_force.hpp"
#include "tumble/ensemble/spin.hpp"

namespace tumble::detail::ensembles {

/// number(body.first), number(body.first + 1), … in the lanes.
template <class P, class Number>
TUMBLE_INLINE P gather(const ensemble::PackBody<P>& body, const Number& number) {
  P all{};
  for (int i = 0; i < simd::lanes<P>; ++i)
    all[i] = number(body.first + static_cast<std::size_t>(i));
  return all;
}
template <class P, class Vector>
TUMBLE_INLINE Point<P> gather_point(const ensemble::PackBody<P>& body, const Vector& vector) {
  return {gather(body, [&](std::size_t i) { return vector(i).x(); }),
          gather(body, [&](std::size_t i) { return vector(i).y(); }),
          gather(body, [&](std::size_t i) { return vector(i).z(); })};
}

/// n/d for each coordinate.
template <class P>
TUMBLE_INLINE Point<P> quotient(const P& n, const Point<P>& d) {
  return {n / d.x, n / d.y, n / d.z};
}

/// What a kernel does unless it says otherwise: nothing.
template <class P>
struct SilentKernel {
  static constexpr bool drags = false;  ///< whether it adds to Push::drag
  static constexpr bool steady = true;  ///< whether push and spin are all it does

  TUMBLE_INLINE void add_push(Push<P>&) const {}

  /// Adds h² I⁻¹ τ of a moment.
  TUMBLE_INLINE void add_spin(const Quaternion<P>&, const Point<P>&, Point<P>&) const {}

  /// Adds the wrench of a force that may depend on the whole motion.
  TUMBLE_INLINE void add_wrench(double, const ensemble::PackBody<P>&,
                                const ensemble::PackKinematics<P>&,
                                ensemble::PackWrench<P>&) const {}

  /// Of h² I⁻¹ τ over a step that begins with the orientation q.
  template <int N>
  struct Series {
    TUMBLE_INLINE void start(const SilentKernel&, const Quaternion<P>&) {}
    /// Adds its coefficient k divided by k + 1, from the coefficients 0 … k of b.
    TUMBLE_INLINE void add(const SilentKernel&, int, const Point<P>*, Point<P>&) {}
  };
};

/// The kernel of a Force on the bodies of a Pack. @tparam Force one of those below, or a PackForce
template <class Force, class P>
struct ForceKernel {
  static_assert(ensemble::PackForce<Force>,
                "an ensemble knows Weight, BodyDrag and ForceAtBodyPoint, each "
                "also as PerBody, and any PackForce");
};

/// Uniform gravity: no torque.
template <class P>
struct ForceKernel<Weight, P> : SilentKernel<P> {
  Point<P> g;

  template <class Forces>
  TUMBLE_INLINE void prepare(const Forces& forces, const ensemble::PackBody<P>& body, double) {
    g = gather_point(body, [&](std::size_t i) { return force_of(forces, i).g; });
  }
  TUMBLE_INLINE void add_push(Push<P>& push) const { push.acceleration = push.acceleration + g; }
};

/// Linear and angular drag.
template <class P>
struct ForceKernel<BodyDrag, P> : SilentKernel<P> {
  static constexpr bool drags = true;
  P drag;
  Point<P> angular_drag;  // h angular / I

  template <class Forces>
  TUMBLE_INLINE void prepare(const Forces& forces, const ensemble::PackBody<P>& body, double h) {
    const P k = gather(body, [&](std::size_t i) { return force_of(forces, i).linear; });
    const P spin = gather(body, [&](std::size_t i) { return force_of(forces, i).angular; });
    drag = k / body.mass;
    angular_drag = h * quotient(spin, body.moments);
  }
  TUMBLE_INLINE void add_push(Push<P>& push) const { push.drag = push.drag + drag; }
  TUMBLE_INLINE void add_spin(const Quaternion<P>&, const Point<P>& b, Point<P>& sum) const {
    sum = sum - scaled_axes(angular_drag, b);
  }
  /// Of the slowing down, over a step.
  template <int N>
  struct Series {
    TUMBLE_INLINE void start(const ForceKernel&, const Quaternion<P>&) {}
    TUMBLE_INLINE void add(const ForceKernel& kernel, int k, const Point<P>* b, Point<P>& sum) {
      sum = add_scaled(sum, -1.0 / (k + 1), scaled_axes(kernel.angular_drag, b[k]));
    }
  };
};

/// τ = p × u with u = Rᵀ F, which is constant in the world: u′ = u × b.
template <class P>
struct ForceKernel<ForceAtBodyPoint, P> : SilentKernel<P> {
  Point<P> force, acceleration;
  Point<P> plus, minus;  // h² I⁻¹ (p_y, p_z, p_x) and h² I⁻¹ (p_z, p_x, p_y)

  template <class Forces>
  TUMBLE_INLINE void prepare(const Forces& forces, const ensemble::PackBody<P>& body, double h) {
    force = gather_point(body, [&](std::size_t i) { return force_of(forces, i).force; });
    acceleration = 1 / body.mass * force;
    const Point<P> p_body =
        gather_point(body, [&](std::size_t i) { return force_of(forces, i).p_body; });
    const Point<P> p = rotate(conjugate(body.axes), p_body);
    const Point<P> per_moments = quotient(P{} + h * h, body.moments);
    plus = scaled_axes(per_moments, {p.y, p.z, p.x});
    minus = scaled_axes(per_moments, {p.z, p.x, p.y});
  }
  TUMBLE_INLINE void add_push(Push<P>& push) const {
    push.acceleration = push.acceleration + acceleration;
  }
  TUMBLE_INLINE Point<P> spin(const Point<P>& u) const {
    return {plus.x * u.z - minus.x * u.y, plus.y * u.x - minus.y * u.z,
            plus.z * u.y - minus.z * u.x};
  }
  TUMBLE_INLINE void add_spin(const Quaternion<P>& q, const Point<P>&, Point<P>& sum) const {
    sum = sum + spin(rotate(conjugate(q), force));
  }
  /// Of the torque, over a step.
  template <int N>
  struct Series {
    Point<P> u[std::size_t{N}];
    TUMBLE_INLINE void start(const ForceKernel& kernel, const Quaternion<P>& q) {
      u[0] = rotate(conjugate(q), kernel.force);
    }
    TUMBLE_INLINE void add(const ForceKernel& kernel, int k, const Point<P>* b, Point<P>& sum) {
      if (k > 0) {
        Point<P> crosses = cross(u[0], b[k - 1]);
#pragma GCC unroll 16
        for (int i = 1; i < k; ++i) crosses = add_cross(crosses, u[i], b[k - 1 - i]);
        u[k] = 1.0 / k * crosses;
      }
      sum = add_scaled(sum, 1.0 / (k + 1), kernel.spin(u[k]));
    }
  };
};

/// A force that the user has defined.
template <ensemble::PackForce Force, class P>
struct ForceKernel<Force, P> : SilentKernel<P> {
  static constexpr bool steady = false;
  const Force* force;

  TUMBLE_INLINE void prepare(const Force& all, const ensemble::PackBody<P>&, double) {
    force = &all;
  }
  TUMBLE_INLINE void add_wrench(double t, const ensemble::PackBody<P>& body,
                                const ensemble::PackKinematics<P>& now,
                                ensemble::PackWrench<P>& sum) const {
    const ensemble::PackWrench<P> wrench = (*force)(t, body, now);
    sum = {sum.force + wrench.force, sum.torque + wrench.torque};
  }
};

}  // namespace tumble::detail::ensembles
