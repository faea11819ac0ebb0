#pragma once
/// @file
/// What a law demands of an answer. Tolerances are absolute, per number, and derived by the spec
/// (k·eps·scale, C·hᵖ, 4σ/√n).

#include <cmath>
#include <string>
#include <utility>

#include "judge/protocol/convert.hpp"
#include "judge/protocol/value.hpp"

namespace tumble::judge {

/// How far apart two answers are: the largest difference of two numbers at the same place; NaN
/// where exactly one of them is not finite or the shapes differ, 0 where both are the same
/// non-finite value.
using Metric = double (*)(const Value& a, const Value& b);

/// The larger of two errors, where NaN is larger than everything. (std::fmax drops it, and so may
/// Eigen's maxCoeff(): a law that looked at an answer through these would let NaN pass.)
inline double worse(double a, double b) { return std::isnan(a) || a > b ? a : b; }

double largest_difference(const Value& a, const Value& b);
/// Of the finite numbers in a value; 0 if it has none.
double largest_magnitude(const Value& value);
/// The same for quaternions as rotations: q and −q are one.
double difference_up_to_sign(const Value& a, const Value& b);
/// q or −q, whichever is nearer to the answer.
Value with_sign_of(const Value& q, const Value& answer);

/// What is demanded, written as an answer has it where there are several ways: the same rotation as
/// q or −q, whichever is nearer.
using Restate = Value (*)(const Value& demanded, const Value& answer);

/// An answer near a value.
struct CloseTo {
  Value expected;
  double tolerance;
  Metric metric;
  Restate restate = [](const Value& demanded, const Value&) { return demanded; };
};

template <class T>
CloseTo close_to(const T& expected, double tolerance) {
  return {to_value(expected), tolerance, largest_difference};
}

/// The same rotation as the unit quaternion `expected`: q or −q.
template <class T>
CloseTo same_rotation(const T& expected, double tolerance) {
  return {to_value(expected), tolerance, difference_up_to_sign, with_sign_of};
}

/// An answer that has a property: `error` measures by how much it is missed.
struct Obeys {
  std::string law;  ///< "RᵀR = 1"
  double error;
  double bound;
  bool is_count = false;  ///< of calls, say: then `error` is how many there are
};

inline Obeys obeys(std::string law, double error, double bound) {
  return {std::move(law), error, bound};
}

/// "f is evaluated at most 50 times": how many there are, and how many there may be.
inline Obeys at_most(std::string law, double count, double most) {
  return {std::move(law), count, most, true};
}

}  // namespace tumble::judge
