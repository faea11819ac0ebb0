#pragma once
/// @file
/// What a user's own force on an ensemble is given and has to give: what a BodyForce is, for as
/// many bodies at once as a Pack has lanes. + − * / work in all lanes, with doubles too:
///
///     struct Pull {
///       double k;
///       template <class P>
///       TUMBLE_INLINE PackWrench<P> operator()(double t, const PackBody<P>& body,
///                                              const PackKinematics<P>& now) const {
///         return PackWrench<P>{-k * now.x, {}};
///       }
///     };
///
/// TUMBLE_INLINE, because it has to be compiled with the instructions of the loop around it. (A
/// lambda has __attribute__((always_inline)) behind its parameters.)

#include <concepts>

#include "tumble/ensemble/eights.hpp"

namespace tumble::ensemble {

/// @addtogroup ensemble
/// @{

/// The constants of some bodies.
template <class P>
struct PackBody {
  std::size_t first;         ///< number of the body in lane 0; some lanes may be behind the last
  P mass;                    ///< [kg]
  simd::Point<P> moments;    ///< principal moments of inertia A, B, C [kg m²]
  simd::Point<P> asymmetry;  ///< (B − C)/A, (C − A)/B, (A − B)/C
  simd::Quaternion<P> axes;  ///< principal axes → the body's own axes
};

/// Their motion at one moment, in world coordinates.
template <class P>
struct PackKinematics {
  simd::Point<P> x;       ///< centre of mass [m]
  simd::Quaternion<P> q;  ///< orientation, the body's own axes → world; of length 1, but
                          ///< within a step for (h |ω|)⁴/40 at most
  simd::Point<P> v;       ///< velocity of the centre of mass [m/s]
  simd::Point<P> omega;   ///< angular velocity [rad/s]
};

/// Forces and torques about the centres of mass, in world coordinates.
template <class P>
struct PackWrench {
  simd::Point<P> force;   ///< [N]
  simd::Point<P> torque;  ///< [N m]
};

/// A callable (t, body, now) → PackWrench for every Pack.
template <class F>
concept PackForce = requires(const F& force, double t, const PackBody<simd::FourDoubles>& body,
                             const PackKinematics<simd::FourDoubles>& now) {
  { force(t, body, now) } -> std::same_as<PackWrench<simd::FourDoubles>>;
};

/// @}

}  // namespace tumble::ensemble
