#pragma once
/// @file
/// The step of many games.

#include "common.hpp"

namespace rigid_body_chapter {

/// The way of many games: momenta first, then the rest with the new momenta.
struct MomentaFirst {
  static constexpr int order = 1;

  template <class F>
  static PackedState<double> step(F&& f, double t, const PackedState<double>& y, double h) {
    PackedState<double> next = y;
    next.tail<6>() += h * f(t, y).template tail<6>();
    next.head<7>() += h * f(t, next).template head<7>();
    return next;
  }
};

}  // namespace rigid_body_chapter
