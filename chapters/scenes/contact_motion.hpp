#pragma once
/// @file
/// The motion of a scene in which bodies can touch something.

#include <string>

#include "scenes/motions.hpp"

namespace tumble::scenes {

/// What it is called in reports.
inline constexpr const char* flights_method = "flights in closed form, from impact to impact";

/// From impact to impact, up to the end, to where the scene is stopped, or to a contact that is not
/// modelled.
Motions move_in_contact(const Scene& scene, const contact::ContactScene& with_walls);

/// Whether the bodies were followed as far as the scene asks.
bool complete(const Contacts& contacts);

/// How a body goes on after the end: "at rest since t = 0.71 s", "in flight", …
std::string how_it_ended(const Scene& scene, const Motions& motions, std::size_t body);

/// Whom an impact was on: the name of a wall or of a body.
const std::string& hit_name(const Scene& scene, const contact::ImpactEvent& impact);

}  // namespace tumble::scenes
