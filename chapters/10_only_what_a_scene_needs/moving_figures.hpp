#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 10.10: error against evaluations, the error that is asked for, and what is chosen.
extern const support::MovingFigure work;

}  // namespace tumble::figures
