#pragma once
/// @file
/// Bodies that fly and hit each other, floors and walls: from impact to impact, each flight in
/// closed form, each impact at its own time.
///
/// Source of the scheme: Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", PhD
/// thesis, Berkeley (1996), §2.

#include "tumble/contact/contact_run.hpp"
#include "tumble/contact/scene.hpp"

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
ContactRun simulate_contacts(const ContactScene& scene, const ContactSettings& settings);

/// @}

}  // namespace tumble::contact

#ifndef TUMBLE_COMPILED
#include "tumble/contact/simulate_contacts.inl"
#endif
