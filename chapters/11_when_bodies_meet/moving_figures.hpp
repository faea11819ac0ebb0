#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 11.7: a rod meets the floor, and the impulses that it can get.
extern const support::MovingFigure impulses;

/// Figure 11.9: a die that is thrown, and its energy.
extern const support::MovingFigure strip;

}  // namespace tumble::figures
