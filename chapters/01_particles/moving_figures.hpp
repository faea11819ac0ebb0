#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// One revolution by three methods at the same price, and what error it buys.
extern const support::MovingFigure price;

}  // namespace tumble::figures
