#pragma once
/// @file
/// Mirtich's second level: integrals over a face in space from those over its shadow in a
/// coordinate plane, the one where the shadow is largest.
///
/// On the face n · x + w = 0, so γ = −(n_α α + n_β β + w)/n_γ, and dA = dα dβ / |n_γ|.
/// Source: Mirtich, JGT 1(2), 1996: §4.3 (theorem 3). (α, β, γ) is (x, y, z) turned in a cycle.

#include <cmath>

#include "tumble/mass/mirtich/projection_integrals.hpp"

namespace tumble::mirtich {

/// @addtogroup mass
/// @{

/// The plane n · x + w = 0 of a face.
struct Plane {
  Vec3 n;    ///< unit normal, outwards
  double w;  ///< minus the distance from the origin [m]
};

/// ∬ f dA over a face for the monomials f that are needed.
struct FaceIntegrals {
  double a = 0, b = 0, c = 0;        ///< of α, β, γ           [m³]
  double aa = 0, bb = 0, cc = 0;     ///< of α², β², γ²        [m⁴]
  double aaa = 0, bbb = 0, ccc = 0;  ///< of α³, β³, γ³        [m⁵]
  double aab = 0, bbc = 0, cca = 0;  ///< of α²β, β²γ, γ²α     [m⁵]
};

/// γ: the axis that the normal is nearest to; then α = γ + 1, β = γ + 2 (modulo 3).
inline int projection_axis(const Vec3& n) {
  int axis = 0;
  n.cwiseAbs().maxCoeff(&axis);
  return axis;
}

/// The face integrals from the projection integrals.
/// @param gamma the axis that was projected along, projection_axis(plane.n)
inline FaceIntegrals face_integrals(const ProjectionIntegrals& p, const Plane& plane, int gamma) {
  const double na = plane.n[(gamma + 1) % 3], nb = plane.n[(gamma + 2) % 3], w = plane.w;
  const double k1 = 1 / plane.n[gamma], k2 = k1 * k1, k3 = k2 * k1, k4 = k3 * k1;
  // ∬ of h, h², h³ and of h, h² times α … with h = n_α α + n_β β + w = −n_γ γ
  const double h = na * p.a + nb * p.b + w * p.one;
  const double ha = na * p.aa + nb * p.ab + w * p.a;
  const double hb = na * p.ab + nb * p.bb + w * p.b;
  const double haa = na * p.aaa + nb * p.aab + w * p.aa;
  const double hab = na * p.aab + nb * p.abb + w * p.ab;
  const double hbb = na * p.abb + nb * p.bbb + w * p.bb;
  const double hh = na * ha + nb * hb + w * h;
  const double hha = na * haa + nb * hab + w * ha;
  const double hhb = na * hab + nb * hbb + w * hb;
  const double hhh = na * hha + nb * hhb + w * hh;
  return {k1 * p.a,   k1 * p.b,   -k2 * h,    //
          k1 * p.aa,  k1 * p.bb,  k3 * hh,    //
          k1 * p.aaa, k1 * p.bbb, -k4 * hhh,  //
          k1 * p.aab, -k2 * hbb,  k3 * hha};
}

/// @}

}  // namespace tumble::mirtich
