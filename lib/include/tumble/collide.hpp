#pragma once
/// @file
/// Everything about where bodies are to each other, and when they touch.

/// @defgroup collide Collision geometry
/// Everything about where bodies are to each other, and when they touch.

#include "tumble/collide/bounds.hpp"
#include "tumble/collide/bounds_grid.hpp"
#include "tumble/collide/box_axes.hpp"
#include "tumble/collide/contact_points.hpp"
#include "tumble/collide/convex.hpp"
#include "tumble/collide/difference.hpp"
#include "tumble/collide/distance.hpp"
#include "tumble/collide/first_contact.hpp"
#include "tumble/collide/first_meeting.hpp"
#include "tumble/collide/hull_points.hpp"
#include "tumble/collide/motion.hpp"
#include "tumble/collide/moving_gap.hpp"
#include "tumble/collide/nearest_in_simplex.hpp"
#include "tumble/collide/penetration.hpp"
#include "tumble/collide/sort_and_sweep.hpp"

/// Who can touch, how far apart bodies are, and when they first touch.
/// @ingroup collide
namespace tumble::collide {}
