#pragma once
/// @file
/// What all parts of this chapter's program share.

#include <numbers>
#include <string>
#include <vector>

#include "support/random.hpp"
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
using support::Random;
using support::Table;
using support::Vec2;

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// A body at a time.
struct Moment {
  double t;
  Derived<> now;
};

/// The motion at `count` moments, equally far apart.
template <class Rhs>
std::vector<Moment> followed(const Rhs& motion, const RigidBodyState<>& start, double duration,
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
