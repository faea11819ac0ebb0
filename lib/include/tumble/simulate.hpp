#pragma once
/// @file
/// State the error, get the cheapest way.

/// @defgroup simulate Simulation
/// State the error, get the cheapest way.

#include "tumble/simulate/any_forces.hpp"
#include "tumble/simulate/backwards.hpp"
#include "tumble/simulate/closed_trajectories.hpp"
#include "tumble/simulate/computed_trajectory.hpp"
#include "tumble/simulate/event_count.hpp"
#include "tumble/simulate/first_event.hpp"
#include "tumble/simulate/general_trajectory.hpp"
#include "tumble/simulate/growth_of_errors.hpp"
#include "tumble/simulate/held.hpp"
#include "tumble/simulate/held_error.hpp"
#include "tumble/simulate/late_times.hpp"
#include "tumble/simulate/motion_difference.hpp"
#include "tumble/simulate/motion_record.hpp"
#include "tumble/simulate/motion_tolerance.hpp"
#include "tumble/simulate/no_time.hpp"
#include "tumble/simulate/pieces.hpp"
#include "tumble/simulate/run_settings.hpp"
#include "tumble/simulate/scaled_body.hpp"
#include "tumble/simulate/scaled_rhs.hpp"
#include "tumble/simulate/scaled_scene_rhs.hpp"
#include "tumble/simulate/simulate.hpp"
#include "tumble/simulate/simulate_bodies.hpp"
#include "tumble/simulate/simulate_changes.hpp"
#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/stated_error.hpp"
#include "tumble/simulate/steady_trajectory.hpp"
#include "tumble/simulate/stiff_step.hpp"
#include "tumble/simulate/stiffness_watch.hpp"
#include "tumble/simulate/trajectory.hpp"
#include "tumble/simulate/turning_trajectory.hpp"
#include "tumble/simulate/valid_start.hpp"
#include "tumble/simulate/write_states.hpp"
