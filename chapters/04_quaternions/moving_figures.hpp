#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 4.6: four ways to an orientation that the reader turns.
extern const support::MovingFigure tracks;

}  // namespace tumble::figures
