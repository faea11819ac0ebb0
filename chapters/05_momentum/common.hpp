#pragma once
/// @file
/// What all parts of this chapter's program share.

#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/body.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"
#include "tumble/rotation.hpp"

namespace momentum_chapter {

using namespace tumble;
using support::degrees;
using support::error_number;
using support::error_or_rounding;
using support::number;
using support::Table;
using support::Vec2;

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// Numbers that are the same in every run and with every compiler.
class Dice {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  /// Its numbers are drawn one after the other, whatever order a compiler gives to arguments.
  Vec3 vector(double low, double high) {
    const double x = between(low, high), y = between(low, high);
    return {x, y, between(low, high)};
  }
  Vec3 vector(double size) { return vector(-size, size); }

 private:
  std::mt19937_64 bits_{5};
};

/// A body at a time.
struct Moment {
  double t;
  Derived<> now;
};

/// The motion at `count` moments, equally far apart.
template <class Motion>
std::vector<Moment> followed(const Motion& motion, const RigidBodyState<>& start, double duration,
                             int count) {
  std::vector<Moment> list{{0, derived(motion.body(), start)}};
  PackedState<double> y = pack(start);
  for (int i = 1; i < count; ++i) {
    const double t = duration * i / (count - 1), before = duration * (i - 1) / (count - 1);
    y = integrate_adaptive<Dop853>(motion, y, before, t, {1e-12, 1e-12}).y;
    list.push_back({t, derived(motion.body(), unpack<double>(y))});
  }
  return list;
}

}  // namespace momentum_chapter
