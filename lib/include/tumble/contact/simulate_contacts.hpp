#pragma once
/// @file
/// Bodies that fly and hit each other, floors and walls: from impact to impact, each flight in
/// closed form, each impact at its own time.
///
/// Source of the scheme: Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", PhD
/// thesis, Berkeley (1996), §2.

#include "tumble/contact/contact_simulation.hpp"

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// All impacts of the bodies from t = 0 on, in the order of time.
///
/// Between impacts no error grows: flights are closed forms. Each impact is found to the tolerance.
/// But each also makes the error that there was larger (of a ball that meets another one, by about
/// the flight over the radius): after some dozens, places of bodies that hit each other mean
/// nothing.
/// @throws std::invalid_argument for a scene that is none (see ContactScene::require_valid()), or
///         settings that are none
inline ContactRun simulate_contacts(const ContactScene& scene, const ContactSettings& settings) {
  require(settings.until >= 0 && std::isfinite(settings.until),
          "contacts: until = ", settings.until, " s is not finite and ≥ 0");
  require(settings.tolerance > 0, "contacts: the tolerance ", settings.tolerance,
          " m is not positive");
  require(settings.hop > 0 && std::isfinite(settings.hop), "contacts: hop = ", settings.hop,
          " is not positive and finite");
  require(settings.max_impacts > 0, "contacts: max_impacts = ", settings.max_impacts,
          " is not positive");
  scene.require_valid(settings.tolerance);
  return detail::ContactSimulation<detail::ContactEvents>(scene, settings).run();
}

/// @}

}  // namespace tumble::contact
