#pragma once

#include "tumble/contact/simulate_contacts.hpp"

#include "tumble/contact/contact_simulation.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::contact {

TUMBLE_BODY ContactRun simulate_contacts(const ContactScene& scene,
                                         const ContactSettings& settings) {
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

}  // namespace tumble::contact
