#pragma once
/// @file
/// Which parts of a step a splitting takes in turn: a flow of aᵢ h, a kick of bᵢ h, and so on, the
/// same forwards and backwards.
///
/// Source: Strang, SIAM J. Numer. Anal. 5 (1968); Blanes & Moan, "Practical symplectic partitioned
/// Runge–Kutta and Runge–Kutta–Nyström methods", J. Comput. Appl. Math. 142 (2002), tables 2 and 3
/// (SRKN₆ᵇ and SRKN₁₄ᵃ); Kahan & Li, "Composition constants for raising the orders of
/// unconventional schemes", Math. Comp. 66 (1997), as in Hairer, Lubich & Wanner, "Geometric
/// Numerical Integration" (2nd ed. 2006), §V.3.2.

#include <array>
#include <cstddef>

namespace tumble::geometric {

/// @addtogroup geometric
/// @{

/// Parts of a step, each a kick or a flow in turn.
template <std::size_t n>
struct Composition {
  std::array<double, n> parts;  ///< of h, kicks at even places if kick_first
  bool kick_first;
};

/// @}

}  // namespace tumble::geometric

namespace tumble::detail {

/// Completes the first half of a symmetric scheme whose parts of each kind add up to 1.
template <std::size_t half>
constexpr geometric::Composition<2 * half + 3> symmetric_composition(
    const std::array<double, half>& first, bool kick_first) {
  constexpr std::size_t n = 2 * half + 3;
  geometric::Composition<n> all{{}, kick_first};
  double sums[2] = {};
  for (std::size_t i = 0; i < half; ++i) {
    all.parts[i] = all.parts[n - 1 - i] = first[i];
    sums[i % 2] += first[i];
  }
  // The part next to the middle comes twice, the middle one once.
  constexpr std::size_t middle = half + 1;
  all.parts[half] = all.parts[half + 2] = 0.5 - sums[half % 2];
  all.parts[middle] = 1 - 2 * sums[middle % 2];
  return all;
}

}  // namespace tumble::detail

namespace tumble::geometric {

/// @addtogroup geometric
/// @{

/// Strang's scheme of order 2: half a kick, a flow, half a kick.
struct Strang {
  static constexpr int order = 2;
  static constexpr Composition<3> composition = {{0.5, 1, 0.5}, true};
};

/// Order 4 with six kicks and flows a step; for kinetic energies quadratic in the momenta.
struct BlanesMoan4 {
  static constexpr int order = 4;
  static constexpr auto composition =
      detail::symmetric_composition<5>({0.0829844064174052, 0.245298957184271, 0.396309801498368,
                                        0.604872665711080, -0.0390563049223486},
                                       true);
};

/// Order 6 with fourteen; for kinetic energies quadratic in the momenta.
struct BlanesMoan6 {
  static constexpr int order = 6;
  static constexpr auto composition = detail::symmetric_composition<13>(
      {0.0378593198406116, 0.09171915262446165, 0.102635633102435, 0.183983170005006,
       -0.0258678882665587, -0.05653436583288827, 0.314241403071447, 0.004914688774712854,
       -0.130144459517415, 0.143761127168358, 0.106417700369543, 0.328567693746804,
       -0.00879424312851058},
      false);
};

/// @}

}  // namespace tumble::geometric

namespace tumble::detail {

/// Strang's scheme taken 2n − 1 times, γ₁ … γₙ … γ₁.
template <std::size_t n>
constexpr geometric::Composition<4 * n - 1> repeated_strang(const std::array<double, n>& gamma) {
  geometric::Composition<4 * n - 1> all{{}, true};
  double before = 0;
  for (std::size_t i = 0; i < 2 * n - 1; ++i) {
    const double g = gamma[i < n ? i : 2 * n - 2 - i];
    all.parts[2 * i] = (before + g) / 2;
    all.parts[2 * i + 1] = g;
    before = g;
  }
  all.parts[4 * n - 2] = before / 2;
  return all;
}

}  // namespace tumble::detail

namespace tumble::geometric {

/// @addtogroup geometric
/// @{

/// Order 8: Strang's scheme seventeen times.
struct KahanLi8 {
  static constexpr int order = 8;
  static constexpr auto composition = detail::repeated_strang<9>(
      {0.13020248308889008088, 0.56116298177510838456, -0.38947496264484728641,
       0.15884190655515560090, -0.39590389413323757734, 0.18453964097831570709,
       0.25837438768632204729, 0.29501172360931029887, -0.60550853383003451170});
};

/// @}

}  // namespace tumble::geometric
