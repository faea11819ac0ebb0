#pragma once
/// @file
/// Radau IIA of order 5: the collocation method with three points, the last at the end of the step.
///
///     Zᵢ = h Σ aᵢⱼ f(t + cⱼ h, y + Zⱼ),   y(t + h) = y + Z₃,   A⁻¹ = T Λ T⁻¹
///
/// Λ has the real eigenvalue γ of A⁻¹ and the block (α −β; β α) of the complex pair α ± iβ:
/// Newton's method then solves one real and one complex system instead of one three times as large.
/// Source: Hairer & Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), table
/// IV.5.6 (A, c) and IV.8; T and Λ computed from A to 36 digits.

#include <cmath>

#include "tumble/core/types.hpp"

namespace tumble::detail {

/// The coefficients, rounded to `Scalar`.
template <class Scalar>
struct Radau5Coefficients {
  static constexpr Scalar root6 = Scalar(2.44948974278317809819728407470589139L);

  static constexpr Scalar gamma = Scalar(3.6378342527444957322084185135777758L);
  static constexpr Scalar alpha = Scalar(2.6810828736277521338957907432111121L);
  static constexpr Scalar beta = Scalar(3.0504301992474105694263776247875679L);

  /// Where in the step the collocation points are.
  static Vector3<Scalar> c() { return {(4 - root6) / 10, (4 + root6) / 10, Scalar(1)}; }

  /// Weights of Z/h in the error estimate f(t, y) + Σ eᵢ Zᵢ / h (IV.8.19, divided by γ₀ = 1/γ).
  static Vector3<Scalar> e() {
    return {-(13 + 7 * root6) / 3, (-13 + 7 * root6) / 3, Scalar(-1) / 3};
  }

  static Matrix3<Scalar> T() {
    Matrix3<Scalar> T;
    T << Scalar(0.0944387624889752414874900795064165863L),
        Scalar(-0.141255295020954208427990383807797309L),
        Scalar(-0.0300291941051474244918611170890538667L),
        Scalar(0.250213122965333311376509067512501684L),
        Scalar(0.204129352293799931995990810298338174L),
        Scalar(0.38294211275726193779543823359987321L), Scalar(1), Scalar(1), Scalar(0);
    return T;
  }

  static Matrix3<Scalar> T_inverse() {
    Matrix3<Scalar> T;
    T << Scalar(4.17871859155190472734646265851205623L),
        Scalar(0.327682820761062387082533272429616234L),
        Scalar(0.523376445499449548039930915908987502L),
        Scalar(-4.17871859155190472734646265851205623L),
        Scalar(-0.327682820761062387082533272429616234L),
        Scalar(0.476623554500550451960069084091012498L),
        Scalar(-0.502872634945786875951247343139544293L),
        Scalar(2.57192694985560542918678535360167505L),
        Scalar(-0.596039204828224924968821911099302403L);
    return T;
  }

  /// ℓⱼ(s): the collocation polynomial through 0 at s = 0 and Zⱼ at cⱼ is Σ ℓⱼ(s) Zⱼ.
  static Vector3<Scalar> interpolation_weights(Scalar s) {
    const Vector3<Scalar> x = c();
    return {s * (s - x[1]) * (s - x[2]) / (x[0] * (x[0] - x[1]) * (x[0] - x[2])),
            s * (s - x[0]) * (s - x[2]) / (x[1] * (x[1] - x[0]) * (x[1] - x[2])),
            s * (s - x[0]) * (s - x[1]) / (x[2] * (x[2] - x[0]) * (x[2] - x[1]))};
  }
};

}  // namespace tumble::detail
