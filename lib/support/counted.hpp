#pragma once
/// @file
/// A number that counts the operations it takes part in: what a template of the library costs
/// without a clock.

#include <cmath>
#include <string>

#include "tumble/core/types.hpp"

namespace tumble::support {

/// How often which operation was done.
struct Operations {
  int multiplications = 0;  ///< and divisions
  int additions = 0;        ///< and subtractions
  int functions = 0;        ///< roots, sines, cosines
};

/// A double whose operations are counted in `done`. A change of sign is free.
struct Counted {
  double value = 0;
  static inline Operations done;

  Counted() = default;
  Counted(double v) : value(v) {}  // NOLINT(google-explicit-constructor): stands for a double

  Counted operator-() const { return -value; }
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }
  Counted& operator*=(const Counted& b) { return *this = *this * b; }
  Counted& operator/=(const Counted& b) { return *this = *this / b; }

  friend Counted operator+(const Counted& a, const Counted& b) {
    return ++done.additions, a.value + b.value;
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    return ++done.additions, a.value - b.value;
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    return ++done.multiplications, a.value * b.value;
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    return ++done.multiplications, a.value / b.value;
  }
  friend bool operator==(const Counted& a, const Counted& b) { return a.value == b.value; }
  friend bool operator<(const Counted& a, const Counted& b) { return a.value < b.value; }
  friend bool operator>(const Counted& a, const Counted& b) { return a.value > b.value; }
  friend Counted sqrt(const Counted& a) { return ++done.functions, std::sqrt(a.value); }
  friend Counted sin(const Counted& a) { return ++done.functions, std::sin(a.value); }
  friend Counted cos(const Counted& a) { return ++done.functions, std::cos(a.value); }
};

/// "27 ×, 18 +, 1 √"
inline std::string text_of(const Operations& done) {
  return std::to_string(done.multiplications) + " ×, " + std::to_string(done.additions) + " +" +
         (done.functions > 0 ? ", " + std::to_string(done.functions) + " √" : "");
}

/// The operations of one call.
template <class Action>
Operations count(Action&& action) {
  Counted::done = {};
  action();
  return Counted::done;
}

}  // namespace tumble::support

template <>
struct Eigen::NumTraits<tumble::support::Counted> : Eigen::NumTraits<double> {
  using Real = tumble::support::Counted;
  using NonInteger = tumble::support::Counted;
  using Nested = tumble::support::Counted;
  using Literal = tumble::support::Counted;
};
