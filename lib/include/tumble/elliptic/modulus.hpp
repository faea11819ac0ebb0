#pragma once
/// @file
/// What Jacobi's functions are given, and what they give.

namespace tumble::elliptic {

/// @addtogroup elliptic
/// @{

/// The modulus k of elliptic functions, as the squares of k and of k' = √(1 − k²): each small one
/// of them has all its digits.
struct Modulus {
  double k2;   ///< k², 0 … 1
  double kc2;  ///< k'² = 1 − k²
};

/// A number as its Jacobi functions say it: u with sn u = sn, cn u = cn.
struct Amplitude {
  double sn, cn;  ///< sn² + cn² = 1
};

/// Jacobi's functions of a real u, and the direction of Θ(u + iη) in the complex plane.
struct ThetaValues {
  double sn, cn, dn;
  double cos_half, sin_half;  ///< of half the argument of Θ, less what is linear in u
  double turned;              ///< [rad] what whole periods add to that argument
};

/// @}

}  // namespace tumble::elliptic
