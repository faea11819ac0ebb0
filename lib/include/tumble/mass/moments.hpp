#pragma once
/// @file
/// The ten integrals that mass properties are made of, about a chosen point p:
/// ∫ dV, ∫ r dV, ∫ r rᵀ dV with r = x − p; or the same sums over points with masses.
///
/// p should be near the body: then nothing cancels when the inertia is moved to the centre of mass.
/// Source: any text on mechanics, e.g. Goldstein, "Classical Mechanics" (3rd ed. 2002), §5.3.

#include "tumble/mass/mass_properties.hpp"
#include "tumble/simd/double_double.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// The integrals of 1, x, y, z and their products, of scalars T.
template <class T>
struct Moments {
  T one{};                               ///< [m³], or [kg] for points
  T x{}, y{}, z{};                       ///< the above · m
  T xx{}, yy{}, zz{}, xy{}, yz{}, zx{};  ///< the above · m²

  template <class U>
  TUMBLE_INLINE Moments& operator+=(const Moments<U>& m) {
    one += m.one;
    x += m.x;
    y += m.y;
    z += m.z;
    xx += m.xx;
    yy += m.yy;
    zz += m.zz;
    xy += m.xy;
    yz += m.yz;
    zx += m.zx;
    return *this;
  }
};

namespace detail {

/// The moments of a unit of volume or mass at r, or of one sample.
inline Moments<double> unit_moments(const Vec3& r) {
  const double x = r.x(), y = r.y(), z = r.z();
  return {1, x, y, z, x * x, y * y, z * z, x * y, y * z, z * x};
}

/// Each number rounded to a double.
inline Vec3 to_double(const Vector3<simd::DoubleDouble>& v) {
  return {double(v.x()), double(v.y()), double(v.z())};
}

/// Where the centre of mass is, from the point that the moments are about [m].
inline Vector3<simd::DoubleDouble> centre_from_reference(const Moments<simd::DoubleDouble>& m) {
  return {m.x / m.one, m.y / m.one, m.z / m.one};
}

}  // namespace detail

/// Mass properties from moments about `reference`.
/// @param reference the point p that the moments are about [m]
/// @param density   [kg/m³], or 1 for moments that have masses in them already
MassProperties mass_properties(const Moments<simd::DoubleDouble>& m, const Vec3& reference,
                               double density);

namespace detail {

/// Adds many moments without losing digits: plain sums of short blocks, the blocks in
/// double-double. The error of n terms is that of a sum of `block_size`.
class BlockedMoments {
 public:
  void add(const Moments<double>& m) {
    block_ += m;
    if (++in_block_ == block_size) close_block();
  }
  /// The sum of everything added so far.
  Moments<simd::DoubleDouble> total() const {
    Moments<simd::DoubleDouble> sum = closed_;
    return sum += block_;
  }

 private:
  static constexpr int block_size = 128;
  void close_block() {
    closed_ += block_;
    block_ = {};
    in_block_ = 0;
  }
  Moments<simd::DoubleDouble> closed_;
  Moments<double> block_;
  int in_block_ = 0;
};

}  // namespace detail

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/moments.inl"
#endif
