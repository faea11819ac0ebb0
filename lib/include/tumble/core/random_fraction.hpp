#pragma once
/// @file
/// Random numbers of [0, 1) that are the same on every platform.
///
/// The upper 53 bits of a 64-bit Mersenne Twister, times 2⁻⁵³: standard libraries differ in
/// std::uniform_real_distribution, not in the generator. Source: Matsumoto & Nishimura, "Mersenne
/// Twister", ACM TOMACS 8(1), 1998.

#include <algorithm>
#include <cstdint>
#include <random>

namespace tumble::detail {

/// The next random number, uniform in [0, 1).
inline double random_fraction(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

/// A random number of the i-th of n equal parts of [0, 1).
inline double random_fraction_of_part(std::mt19937_64& engine, int i, int n) {
  return std::min((i + random_fraction(engine)) / n, 1 - 0x1p-53);  // rounding may reach 1
}

}  // namespace tumble::detail
