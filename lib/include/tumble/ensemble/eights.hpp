#pragma once
/// @file
/// How an ensemble lies in memory: structures of arrays, eight bodies each, so that a Pack is read
/// in one piece. What turning needs is together, and apart from what it does not need: a step of
/// very many bodies takes as long as memory takes to be read and written.
///
/// All is in the principal axes of each body, where the tensor has three numbers: (I ω)ᵢ = Iᵢ ωᵢ.

#include "tumble/simd/quaternion.hpp"

namespace tumble::detail::ensembles {

inline constexpr int eight = 8;  ///< bodies in a structure: the lanes of the widest Pack

/// One number for each of eight bodies.
using Row = double[eight];

/// How eight bodies turn: all that this takes where no torque acts.
struct alignas(64) EightSpins {
  Row q[4];          ///< (w, x, y, z), principal axes → world
  Row omega[3];      ///< angular velocity about the principal axes [rad/s]
  Row asymmetry[3];  ///< (B − C)/A, (C − A)/B, (A − B)/C: at most 1, 0 for a ball; stays the same
};

/// Where their centres of mass are [m] and how fast these go [m/s], world coordinates; or were when
/// this was written last: see CommonFall.
struct alignas(64) EightPaths {
  Row x[3], v[3];
};

/// What stays the same, and is needed by forces.
struct alignas(64) EightBodies {
  Row mass;        ///< [kg]
  Row moments[3];  ///< principal moments A, B, C [kg m²]
  Row axes[4];     ///< (w, x, y, z), principal axes → the body's own axes
};

/// The motion of eight bodies.
struct EightMotions {
  EightSpins& spins;
  EightPaths& paths;
};

/// The numbers from a lane on.
template <class P>
TUMBLE_INLINE P load(const Row& row, int lane) {
  P numbers;
  std::memcpy(&numbers, row + lane, sizeof numbers);
  return numbers;
}
template <class P>
TUMBLE_INLINE simd::Point<P> load(const Row (&rows)[3], int lane) {
  return {load<P>(rows[0], lane), load<P>(rows[1], lane), load<P>(rows[2], lane)};
}
template <class P>
TUMBLE_INLINE simd::Quaternion<P> load(const Row (&rows)[4], int lane) {
  return {load<P>(rows[0], lane), load<P>(rows[1], lane), load<P>(rows[2], lane),
          load<P>(rows[3], lane)};
}

template <class P>
TUMBLE_INLINE void store(const P& numbers, Row& row, int lane) {
  std::memcpy(row + lane, &numbers, sizeof numbers);
}
template <class P>
TUMBLE_INLINE void store(const simd::Point<P>& p, Row (&rows)[3], int lane) {
  store(p.x, rows[0], lane);
  store(p.y, rows[1], lane);
  store(p.z, rows[2], lane);
}
template <class P>
TUMBLE_INLINE void store(const simd::Quaternion<P>& q, Row (&rows)[4], int lane) {
  store(q.w, rows[0], lane);
  store(q.x, rows[1], lane);
  store(q.y, rows[2], lane);
  store(q.z, rows[3], lane);
}

}  // namespace tumble::detail::ensembles
