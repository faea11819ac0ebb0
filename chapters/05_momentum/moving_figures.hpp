#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 5.7: a box in free flight, its L and its ω, by four ways to store the spin.
extern const support::MovingFigure wander;

}  // namespace tumble::figures
