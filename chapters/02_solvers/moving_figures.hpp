#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 2.5: z in the plane, the method, and what forty steps do.
extern const support::MovingFigure regions;

}  // namespace tumble::figures
