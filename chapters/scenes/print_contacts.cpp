#include <cmath>
#include <iostream>

#include "scenes/contact_motion.hpp"
#include "scenes/error_growth.hpp"
#include "scenes/motion_output.hpp"
#include "support/terminal.hpp"

namespace tumble::scenes {
namespace {

/// What only rounding has left of a component is 0.
std::string three_digits(const Vec3& v) {
  std::string text;
  for (const double x : v)
    text += (text.empty() ? "" : " ") + support::number(std::abs(x) > 1e-12 * v.norm() ? x : 0);
  return text;
}

/// Of many impacts the first ones and the last ones.
void print_impacts(const Scene& scene, const Motions& motions) {
  constexpr std::size_t first = 12, last = 4;
  const std::vector<contact::ImpactEvent>& impacts = motions.contacts->run.impacts;
  std::cout << "impacts: " << impacts.size();
  if (impacts.size() > first + last)
    std::cout << "; here are the first " << first << " and the last " << last
              << ". --json and --impacts FILE give all of them";
  std::cout << "\n\n";
  support::Table table({"time [s]", "body", "on", "normal", "impulse [N s]", "lost [J]"});
  for (std::size_t k = 0; k < impacts.size(); ++k) {
    if (impacts.size() > first + last && k == first) k = impacts.size() - last;
    const contact::ImpactEvent& impact = impacts[k];
    table.add({support::number(motions.start + impact.t, 9),
               scene.bodies[static_cast<std::size_t>(impact.body)].name, hit_name(scene, impact),
               three_digits(impact.normal), three_digits(impact.impulse),
               support::number(-impact.energy)});
  }
  if (!impacts.empty()) std::cout << support::fitted(table) << '\n';
}

void print_energy(const contact::EnergyLedger& energy) {
  support::Table table({"energy of all bodies", "[J]"});
  table.add({"at the start", support::number(energy.start, 9)});
  table.add({"lost in impacts", support::number(-energy.impacts, 9)});
  table.add({"lost in sliding", support::number(-energy.sliding, 9)});
  table.add({"lost when put to rest", support::number(-energy.settled, 9)});
  table.add({"at the end", support::number(energy.end, 9)});
  std::cout << support::fitted(table) << '\n';
}

void print_growth(const Scene& scene, const Motions& motions) {
  const ErrorGrowth growth = error_growth(*motions.contacts);
  std::cout << support::fitted(
                   "Each flight is exact, but each impact makes earlier errors larger. We have "
                   "followed a second start, with speeds that differ by " +
                   support::number(growth.start) +
                   " of themselves: at the end the two motions are up to " +
                   support::error_number(growth.distance) +
                   " m apart, and turned against each other by up to " +
                   support::error_number(growth.angle) +
                   " rad. Once they are farther apart than the body reaches, its motion means "
                   "nothing.")
            << '\n';
  support::Table table(
      {"body", "bounces", "an error grows per bounce", "its motion means nothing after"});
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyGrowth& of = growth.bodies[i];
    table.add({scene.bodies[i].name, std::to_string(of.bounces),
               of.factor ? support::number(*of.factor, 3) + " times" : "too few to say",
               of.means_nothing_after
                   ? support::number(motions.start + *of.means_nothing_after, 4) + " s"
                   : "not before the end"});
  }
  std::cout << support::fitted(table) << '\n';
}

/// Contact that lasts is the one thing here that has no bound.
void print_hops(const Scene& scene, const Motions& motions) {
  std::string hopped;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (const auto hops = motions.contacts->run.hops(i); hops > 0)
      hopped += (hopped.empty() ? "" : ", ") + support::escaped(scene.bodies[i].name) + " (" +
                std::to_string(hops) + (hops == 1 ? " hop)" : " hops)");
  if (hopped.empty()) return;
  std::cout << support::fitted("These stayed in touch and moved on, in hops: " + hopped +
                               ". That is not exact, and the comparison above does not see it. "
                               "Where a body slides in a curve or tips, expect its way and its "
                               "times to be off by some per cent, by more where it is slow; what "
                               "is round but no ball slows down as it rolls, and may stop; what "
                               "spins upright is hardly slowed.")
            << "\n\n";
}

}  // namespace

void print_contacts(const Scene& scene, const Motions& motions) {
  print_impacts(scene, motions);
  print_energy(motions.contacts->run.energy);
  print_growth(scene, motions);
  print_hops(scene, motions);
}

}  // namespace tumble::scenes
