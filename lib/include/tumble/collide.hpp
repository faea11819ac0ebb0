#pragma once
/// @file
/// Everything about where bodies are to each other, and when they touch.

/// @defgroup collide Collision geometry
/// Everything about where bodies are to each other, and when they touch.

#include "tumble/collide/bounds.hpp"
#include "tumble/collide/sort_and_sweep.hpp"

/// Who can touch, how far apart bodies are, and when they first touch.
/// @ingroup collide
namespace tumble::collide {}
