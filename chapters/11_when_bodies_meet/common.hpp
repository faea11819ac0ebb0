#pragma once
/// @file
/// What all parts of this chapter's program share: how numbers are written.

#include <cmath>
#include <string>
#include <vector>

#include "planar_impact.hpp"
#include "support/plot.hpp"
#include "support/random.hpp"
#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/body.hpp"
#include "tumble/contact.hpp"

namespace contact_chapter {

using support::degrees, support::error_number, support::error_or_rounding, support::number;
using support::Pen, support::Plot, support::Series, support::Sketch, support::Table;

constexpr double gravity = 9.81;

// ── Numbers ──

/// Rounded, so that the last digits of another compiler make no other text, and never −0.
inline std::string rounded(double x, int digits = 3) {
  const double scale = std::pow(10, digits), near = std::round(scale * x) / scale;
  return number(near == 0 ? 0 : near, 6);
}

/// A share in percent, with its sign.
inline std::string percent(double share) {
  const std::string text = rounded(100 * share, 1);
  return (text == "0" || share < 0 ? "" : "+") + text + " %";
}

inline std::string yes_or_no(bool yes) { return yes ? "yes" : "no"; }

}  // namespace contact_chapter
