#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 7.9: a racket in the box along the axes, and two throws, with its own inertia and with
/// the box's.
extern const support::MovingFigure throws;

}  // namespace tumble::figures
