/// @file
/// libFuzzer on scene files: whatever the bytes, reading them ends, with a scene or with words. A
/// scene with contact is followed for some impacts: no energy comes from nowhere, no number is
/// none.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "project/fuzz/check_mesh.hpp"
#include "scenes/contact_scene.hpp"
#include "tumble/contact/can_touch.hpp"
#include "tumble/contact/simulate_contacts.hpp"

namespace {

using namespace tumble;

/// Whether sizes, times and speeds are such that sums of their squares mean something.
bool is_of_this_world(const contact::ContactScene& scene, double until) {
  const auto fits = [](double x) { return x == 0 || (x > 1e-6 && x < 1e6); };
  bool all = fits(until) && fits(scene.gravity.norm());
  for (const contact::ContactBody& b : scene.bodies) {
    const Derived<> now = derived(b.body, b.start);
    const double fastest =
        now.v.norm() + b.shape.reach() * now.omega.norm() + scene.gravity.norm() * until;
    all = all && fits(b.shape.reach()) && fits(b.body.mass()) && fits(now.x.norm()) &&
          fits(now.v.norm()) && fits(now.omega.norm()) &&
          fastest * until < 1e3 * b.shape.reach();  // else a contact takes many queries
  }
  return all;
}

void follow(const scenes::Scene& scene) {
  constexpr int impacts = 30;
  const contact::ContactScene with_walls = scenes::contact_scene(scene);
  const double until = scene.task.t1 - scene.task.t0;
  const bool touch = contact::can_touch(with_walls, until);
  if (!is_of_this_world(with_walls, until)) return;
  const contact::ContactRun run =
      simulate_contacts(with_walls, {.until = until,
                                     .tolerance = scenes::contact_tolerance(scene),
                                     .hop = 1e-4,
                                     .max_impacts = impacts});
  fuzz::demand(touch || run.impacts.empty(), "what cannot touch has no impacts");
  double scale = 0;
  for (std::size_t i = 0; i < with_walls.bodies.size(); ++i) {
    const contact::ContactBody& b = with_walls.bodies[i];
    const RigidBodyState<> end = run.state(with_walls, static_cast<int>(i), run.t);
    fuzz::demand(pack(end).allFinite(), "states are finite");
    for (const RigidBodyState<>& state : {b.start, end})
      scale += kinetic_energy(b.body, state) +
               b.body.mass() * scene.gravity.norm() * (state.x.norm() + b.shape.reach());
  }
  const double balance =
      run.energy.start + run.energy.impacts + run.energy.sliding + run.energy.settled;
  fuzz::demand(std::abs(balance - run.energy.end) <= 1e-9 * scale, "energies add up");
  for (const contact::ImpactEvent& impact : run.impacts)
    fuzz::demand(impact.energy <= 1e-9 * scale, "no impact creates energy");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const scenes::Scene scene = scenes::parse_scene(text, "scene.json", "/nonexistent");
    if (scene.contact) follow(scene);
  } catch (const std::invalid_argument& refusal) {
    fuzz::demand(refusal.what()[0] != 0, "a refusal has words");
  } catch (const std::runtime_error& refusal) {  // a file of a mesh that is not there
    fuzz::demand(refusal.what()[0] != 0, "a failure has words");
  }
  return 0;
}
