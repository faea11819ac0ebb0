#pragma once
/// @file
/// Points that fill the unit cube evenly at every count: x_i = frac(½ + i (1/g, 1/g², 1/g³))
/// with g⁴ = g + 1, the generalisation of the golden ratio to three dimensions.
///
/// Chosen by measurement: the errors of the inertia of four turned solids are 2 times below
/// those of random points at 10³, 3 times at 10⁴ and 5 times at 2.5·10⁵, as Halton's and
/// within a fifth of Sobol's, for one addition a coordinate, and any count will do. Source:
/// Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018); the additive
/// recurrence is Kronecker's, see Niederreiter, "Random Number Generation and Quasi-Monte
/// Carlo Methods" (1992), §3.1.

#include <random>

#include "tumble/core/require.hpp"
#include "tumble/mass/sample_points.hpp"

namespace tumble::sampling {

/// @addtogroup mass
/// @{

/// The first n points of the R3 sequence.
class R3Points {
 public:
  /// The sequence that starts from (½, ½, ½).
  /// @throws std::invalid_argument if count ≤ 0
  explicit R3Points(std::int64_t count) : count_(count) {
    require(count > 0, "the number of low-discrepancy points is ", count, ", not positive");
  }

  /// The sequence that starts from a random point: just as even, and right on average, so that
  /// several of them tell the error (replicated_sampling.hpp). Source: Cranley & Patterson,
  /// "Randomization of number theoretic methods for multiple integration", SIAM J. Numer. Anal. 13
  /// (1976).
  /// @param seed the same seed gives the same points
  /// @throws std::invalid_argument if count ≤ 0
  R3Points(std::int64_t count, std::uint64_t seed) : R3Points(count) {
    std::mt19937_64 engine(seed);
    x_ = engine();
    y_ = engine();
    z_ = engine();
  }

  std::int64_t count() const { return count_; }

  Vec3 next() {
    // Fractions in units of 2⁻⁶⁴: they wrap around by themselves, and no digit is lost
    // with growing i.
    x_ += 0xd1b54a32d192ed04, y_ += 0xabc98388fb8fac03,
        z_ += 0x8cb92ba72f3d8dd7;  // 2⁶⁴/g, /g², /g³
    return {fraction(x_), fraction(y_), fraction(z_)};
  }

 private:
  static double fraction(std::uint64_t x) { return static_cast<double>(x >> 11) * 0x1p-53; }
  static constexpr std::uint64_t half = std::uint64_t{1} << 63;
  std::int64_t count_;
  std::uint64_t x_ = half, y_ = half, z_ = half;
};

/// @}

}  // namespace tumble::sampling
