#pragma once
/// @file
/// The path of the angular momentum in a free body: the curve in which a sphere, |L|² = G², and an
/// ellipsoid, Σ L²ᵢ/Jᵢ = 2T, meet.
///
/// Between turning about the largest and about the smallest axis lies the separatrix G² = 2 T J₂.
/// How far a body is from it is a difference of two products that nearly cancel; it decides when
/// the body flips. So it is computed with twice the digits, from L turned into the body with twice
/// the digits; everything else is sums of positive terms.
///
/// Source: Landau & Lifshitz, "Mechanics" (1976), §37, eqs. 37.8 to 37.12.

#include <optional>

#include "tumble/body/exact_omega.hpp"
#include "tumble/elliptic/integrals.hpp"
#include "tumble/elliptic/modulus.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble::elliptic {

/// @addtogroup free_body
/// @{

/// The constants of a free motion, about principal axes of which the third is the one that is
/// turned about.
struct Polhode {
  double G;         ///< |L|, in the unit of the moments and 1/s
  Vec3 J;           ///< principal moments, ascending or descending, in units of about the largest
  Modulus modulus;  ///< of the elliptic functions
  double lambda;    ///< du/dt [1/s], negative where the moments descend
  double u0;        ///< u at t = 0
  Vec3 amplitudes;  ///< m̂: the direction of L in the body is (m̂₁ cn u, m̂₂ sn u, m̂₃ dn u)
  bool pole_is_axis;  ///< whether angles are counted about axis 3, else about axis 1
  Amplitude eta;      ///< see FreeAsymmetricTop
  Quat frame;         ///< body → principal axes, the pole last
};

/// @}

}  // namespace tumble::elliptic

namespace tumble::detail {

/// L in principal axes, for an L of about 1.
Vec3dd principal_momentum(const PrincipalAxes& p, const Quat& q, const Vec3& L);

/// G² − 2 T J₂, positive if the body turns about the axis of the largest moment.
simd::DoubleDouble separation(const Vec3& moments, const Vec3dd& m);

/// Axes by number and sign.
struct SignedAxes {
  int order[3];
  double sign[3];

  Vec3 of(const Vec3& v) const { return {v[order[0]], v[order[1]], v[order[2]]}; }
};

/// The axes, that of turning last, in which m₁ ≥ 0 and m₃ > 0 at the start; right-handed.
SignedAxes signed_axes(const Vec3dd& m, bool about_largest);

/// Body → principal axes with axis 3 last, or (2, 3, 1).
Quat frame_of(const Mat3& R, const SignedAxes& axes, bool pole_is_axis);

/// The polhode through the direction of L.
/// @param s          squares of the direction's components
/// @param separation |G² − 2 T J₂| / G²
elliptic::Polhode polhode_through(const Vec3& J, const Vec3& s, double separation, double G);

/// u where (cn u, sn u) are these, −K … K.
inline double start_of(const elliptic::Modulus& k, double cn, double sn) {
  return sn * carlson_rf(cn * cn, k.kc2 + k.k2 * cn * cn, 1);
}

}  // namespace tumble::detail

namespace tumble::elliptic {

/// @addtogroup free_body
/// @{

/// The polhode of a free body, or nothing if L is 0 or along a principal axis, so that the body
/// turns uniformly. (Parts of L below 1e-150 of it count as none.)
/// @param axes with three different moments
/// @param q    body → world, of any length but zero
/// @param L    world coordinates [kg m²/s]
std::optional<Polhode> polhode_of(const PrincipalAxes& axes, const Quat& q, const Vec3& L);

/// @}

}  // namespace tumble::elliptic

#ifndef TUMBLE_COMPILED
#include "tumble/free_body/polhode.inl"
#endif
