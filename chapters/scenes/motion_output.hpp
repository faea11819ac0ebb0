#pragma once
/// @file
/// The motion of a scene as JSON, as CSV, as a picture and as text for the terminal.

#include <ostream>
#include <string>

#include "scenes/json.hpp"
#include "scenes/motions.hpp"

namespace tumble::scenes {

/// Everything, with all digits. Records are written one by one: there may be millions.
void write_scene_json(std::ostream& out, const Scene& scene, const Motions& motions,
                      const std::string& file);

/// What there is to say only of a scene with contact, for the same object.
Json contact_json(const Scene& scene, const Motions& motions);

/// The recorded states, one line per time and body.
void write_states_csv(std::ostream& csv, const Scene& scene, const Motions& motions);

/// One line per impact.
std::string impacts_csv(const Scene& scene, const Motions& motions);

/// How each body turns about its own axes over time, as SVG. It has as many points as one can see.
std::string spin_plot(const Scene& scene, const Motions& motions);

/// The bodies of a scene with contact at some equal times, and the ways of their centres, as SVG.
std::string film_strip(const Scene& scene, const Motions& motions);

/// Prints where each body is at the end, and what that took.
void print_motion(const Scene& scene, const Motions& motions);

/// Prints impacts, energies and how far errors have grown.
void print_contacts(const Scene& scene, const Motions& motions);

}  // namespace tumble::scenes
