#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 6.5: a ray that is dragged onto corners, counted by three rules.
extern const support::MovingFigure corners;

/// Figure 6.12: a mug that is sampled in the reader's way, and the errors on logarithmic scales.
extern const support::MovingFigure sampled;

}  // namespace tumble::figures
