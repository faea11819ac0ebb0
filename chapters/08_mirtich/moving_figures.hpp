#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// Figure 8.5: signed triangles over the edges of an outline, their apex near or far.
extern const support::MovingFigure tetrahedra;

}  // namespace tumble::figures
