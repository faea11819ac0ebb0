// expect: wrong | named float
// The stretch is a float.
#include "contract.hpp"

namespace mirtich {

FaceIntegrals face_integrals(const ProjectionIntegrals& shadow, const Plane& plane, int gamma) {
  const ProjectionIntegrals& p = shadow;
  const double n_alpha = plane.n[(gamma + 1) % 3], n_beta = plane.n[(gamma + 2) % 3];
  const double n_gamma = plane.n[gamma];
  // n · x + w = 0  ⇒  γ = A α + B β + C
  const double A = -n_alpha / n_gamma, B = -n_beta / n_gamma, C = -plane.w / n_gamma;

  // Over the shadow: ∬ γ f = A ∬ α f + B ∬ β f + C ∬ f, one γ after the other.
  const double c = A * p.a + B * p.b + C * p.one;
  const double ca = A * p.aa + B * p.ab + C * p.a;
  const double cb = A * p.ab + B * p.bb + C * p.b;
  const double caa = A * p.aaa + B * p.aab + C * p.aa;
  const double cab = A * p.aab + B * p.abb + C * p.ab;
  const double cbb = A * p.abb + B * p.bbb + C * p.bb;
  const double cc = A * ca + B * cb + C * c;
  const double cca = A * caa + B * cab + C * ca;
  const double ccb = A * cab + B * cbb + C * cb;
  const double ccc = A * cca + B * ccb + C * cc;

  // dA = dα dβ / n_γ: where n_γ is negative, so is the shadow.
  const float stretch = 1 / n_gamma;
  return {stretch * p.a,   stretch * p.b,   stretch * c,    //
          stretch * p.aa,  stretch * p.bb,  stretch * cc,   //
          stretch * p.aaa, stretch * p.bbb, stretch * ccc,  //
          stretch * p.aab, stretch * cbb,   stretch * cca};
}

}  // namespace mirtich
