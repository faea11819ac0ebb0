#pragma once
/// @file
/// The chapter's figures that a reader moves: each in the file of its name.

#include "support/moving_figure.hpp"

namespace tumble::figures {

/// The T-handle, the path of L in it, and its spins: by the right law, and by two wrong ones.
extern const support::MovingFigure handle;

}  // namespace tumble::figures
