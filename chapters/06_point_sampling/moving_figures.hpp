#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 6.5: a ray that is dragged onto corners, counted by three rules.
extern const support::MovingFigure corners;

}  // namespace tumble::figures
