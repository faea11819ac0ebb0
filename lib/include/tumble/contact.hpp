#pragma once
/// @file
/// Everything about bodies that hit each other.

/// @defgroup contact Contact
/// Everything about bodies that hit each other.

#include "tumble/contact/can_touch.hpp"
#include "tumble/contact/contact_events.hpp"
#include "tumble/contact/contact_matrix.hpp"
#include "tumble/contact/contact_run.hpp"
#include "tumble/contact/contact_simulation.hpp"
#include "tumble/contact/event_queue.hpp"
#include "tumble/contact/flight.hpp"
#include "tumble/contact/friction_cone.hpp"
#include "tumble/contact/friction_impulse.hpp"
#include "tumble/contact/hops.hpp"
#include "tumble/contact/impact.hpp"
#include "tumble/contact/rest.hpp"
#include "tumble/contact/run_recorder.hpp"
#include "tumble/contact/scene.hpp"
#include "tumble/contact/several_points.hpp"
#include "tumble/contact/simulate_contacts.hpp"
#include "tumble/contact/slide.hpp"
#include "tumble/contact/sliding.hpp"
#include "tumble/contact/thresholds.hpp"

/// What a hit leaves: impulses, with and without friction, that never create energy; and bodies
/// that fly from hit to hit.
/// @ingroup contact
namespace tumble::contact {}
