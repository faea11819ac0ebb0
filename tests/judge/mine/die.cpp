#include "judge/mine/die.hpp"

#include <algorithm>
#include <cmath>

#include "judge/mine/measure.hpp"
#include "judge/protocol/finding.hpp"
#include "objects/die.hpp"
#include "tumble/contact/simulate_contacts.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::judge::mine {

namespace {

using objects::die_edge;

/// The throw of chapter 11's table.
DieQuestion the_throw() {
  constexpr int impacts = 12;  // after more of them the table would say no more
  return {.mass = objects::die().mass(),
          .edge = die_edge,
          .gravity = 9.81,
          .e = 0.6,
          .tolerance = 1e-11,
          .start = pack(objects::thrown_die()),
          .duration = 2,
          .max_impacts = impacts};
}

contact::ContactRun by_library(const DieQuestion& question, double higher) {
  RigidBodyState<> start = unpack<double>(question.start);
  start.x.z() += higher;
  const contact::ContactScene scene{
      {{"die", objects::die(), collide::Convex::box(Vec3::Constant(die_edge)), start}},
      {collide::HalfSpace{Vec3::Zero(), Vec3::UnitZ()}},
      {0, 0, -question.gravity},
      question.e,
      0};
  constexpr double exact = 1e-15;  // [m]
  return contact::simulate_contacts(
      scene, {.until = question.duration, .tolerance = exact, .max_impacts = question.max_impacts});
}

/// [J]; none by its height where it lies on the table.
double energy_of(const DieQuestion& question, const RigidBodyState<>& state) {
  const RigidBody<> die = objects::die();
  return kinetic_energy(die, state) + die.mass() * question.gravity * (state.x.z() - die_edge / 2);
}

/// What the impacts leave of the energy.
std::vector<double> energies_left(const DieQuestion& question, const contact::ContactRun& run) {
  const double at_start = energy_of(question, run.flights[0].front().state);
  std::vector<double> left;
  double energy = at_start;
  for (const contact::ImpactEvent& impact : run.impacts)
    left.push_back((energy += impact.energy) / at_start);
  return left;
}

DieTruth truth_of(const DieQuestion& question) {
  const contact::ContactRun run = by_library(question, 0),
                            other = by_library(question, question.tolerance);
  const std::vector<double> left = energies_left(question, run),
                            other_left = energies_left(question, other);
  DieTruth truth{{}, run.queries};
  double grown = 0, energy_grown = 0;
  for (std::size_t i = 0; i < std::min(left.size(), other_left.size()); ++i) {
    grown = std::max(grown, std::abs(other.impacts[i].t - run.impacts[i].t));
    energy_grown = std::max(energy_grown, std::abs(other_left[i] - left[i]));
    truth.impacts.push_back({run.impacts[i].t, left[i], grown, energy_grown});
  }
  return truth;
}

double lowest_corner(const Numbers& y) {
  const RigidBodyState<> state = unpack<double>(y);
  return state.x.z() -
         die_edge / 2 * to_matrix(rotation::normalize(state.q)).row(2).cwiseAbs().sum();
}

}  // namespace

std::size_t DieResult::common() const {
  return own ? std::min(own->impacts.size(), truth.impacts.size()) : 0;
}

double DieResult::late(std::size_t impact) const {
  return own.value().impacts.at(impact).t - truth.impacts.at(impact).t;
}

double DieResult::energy_left(std::size_t impact) const {
  return energy_of(question, unpack<double>(own.value().impacts.at(impact).after)) /
         energy_of(question, unpack<double>(question.start));
}

std::optional<std::size_t> DieResult::first_wrong() const {
  constexpr double room = 100;
  const std::vector<TrueImpact>& all = truth.impacts;
  for (std::size_t i = 0; i < all.size(); ++i) {
    double near = room * all[i].grown;
    if (i > 0) near = std::min(near, (all[i].t - all[i - 1].t) / 2);
    if (i + 1 < all.size()) near = std::min(near, (all[i + 1].t - all[i].t) / 2);
    if (i >= common() || !(std::abs(late(i)) <= near)) return i;
  }
  return std::nullopt;
}

DieLaws DieResult::laws() const {
  const RigidBodyState<> start = unpack<double>(question.start);
  DieLaws laws;
  double before = 1;
  const auto worse = [](double& largest, double x) {
    if (!(x <= largest)) largest = x;  // not a number counts too
  };
  for (std::size_t i = 0; i < std::min(first_wrong().value_or(common()) + 1, common()); ++i) {
    const Numbers& numbers = own->impacts[i].after;
    const RigidBodyState<> after = unpack<double>(numbers);
    worse(laws.height, std::abs(lowest_corner(numbers)));
    worse(laws.sideways, (after.P - start.P).head<2>().norm() / start.P.norm());
    worse(laws.sideways, std::abs(after.L.z() - start.L.z()) / start.L.norm());
    worse(laws.energy, energy_left(i) - before);
    before = energy_left(i);
  }
  return laws;
}

DieResult die_of(const WorkerProgram& program) {
  DieResult result{the_throw(), truth_of(the_throw()), {}};
  try {
    result.own = drop_die(program, result.question);
  } catch (const NoAnswer& why) {
    result.failure = text_of(why);
  }
  return result;
}

}  // namespace tumble::judge::mine
