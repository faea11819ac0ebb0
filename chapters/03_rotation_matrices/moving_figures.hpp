#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 3.9: a mug whose axes can be pulled, and what each repair makes of it.
extern const support::MovingFigure pulled;

}  // namespace tumble::figures
