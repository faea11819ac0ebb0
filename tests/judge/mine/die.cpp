#include "judge/mine/die.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "judge/mine/measure.hpp"
#include "judge/protocol/finding.hpp"
#include "support/stopwatch.hpp"
#include "tumble/contact/simulate_contacts.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::judge::mine {

namespace {

constexpr double edge = 0.016, density = 1200;  // [m], [kg/m³]
constexpr int impacts = 12;                     // after more of them the table would say no more

RigidBody<> the_die() {
  const double mass = density * edge * edge * edge;
  return {mass, mass * edge * edge / 6 * Mat3::Identity()};
}

/// Thrown forwards and up, with three turns per second.
DieQuestion the_throw() {
  const RigidBody<> die = the_die();
  const Vec3 omega(10, 6 * std::numbers::pi, 4);
  const RigidBodyState<> start{{0, 0, 0.09},
                               Quat(0.9, 0.3, 0.2, 0.25).normalized(),
                               die.mass() * Vec3(0.5, 0, 0.4),
                               die.I_body() * omega};
  return {die.mass(), edge, 9.81, 0.6, 1e-11, pack(start), 2, impacts};
}

contact::ContactRun by_library(const DieQuestion& question, double higher) {
  RigidBodyState<> start = unpack<double>(question.start);
  start.x.z() += higher;
  const contact::ContactScene scene{
      {{"die", the_die(), collide::Convex::box(Vec3::Constant(edge)), start}},
      {collide::HalfSpace{Vec3::Zero(), Vec3::UnitZ()}},
      {0, 0, -question.gravity},
      question.e,
      0};
  const double exact = 1e-13;  // [m]
  return contact::simulate_contacts(
      scene,
      {.until = question.duration, .tolerance = exact, .most_impacts = question.most_impacts});
}

DieTruth truth_of(const DieQuestion& question) {
  const contact::ContactRun run = by_library(question, 0),
                            shifted = by_library(question, question.tolerance);
  DieTruth truth;
  truth.queries = run.queries;
  truth.seconds =
      support::shortest_run(0.01, [&] { support::keep(by_library(question, 0).energy.end); });
  double grown = 0, energy = run.energy.start;
  for (std::size_t i = 0; i < std::min(run.impacts.size(), shifted.impacts.size()); ++i) {
    truth.t.push_back(run.impacts[i].t);
    grown = std::max(grown, std::abs(shifted.impacts[i].t - run.impacts[i].t));
    truth.grown.push_back(grown);
    energy += run.impacts[i].energy;
    truth.energy_left.push_back(energy / run.energy.start);
  }
  return truth;
}

/// [J], above the table.
double energy_of(const DieQuestion& question, const Numbers& y) {
  const RigidBodyState<> state = unpack<double>(y);
  const RigidBody<> die = the_die();
  return kinetic_energy(die, state) + die.mass() * question.gravity * state.x.z();
}

double lowest_corner(const Numbers& y) {
  const RigidBodyState<> state = unpack<double>(y);
  return state.x.z() - edge / 2 * to_matrix(rotation::normalize(state.q)).row(2).cwiseAbs().sum();
}

}  // namespace

double DieResult::late(std::size_t impact) const {
  return own->answer.impacts[impact].t - truth.t[impact];
}

double DieResult::energy_left(std::size_t impact) const {
  return energy_of(question, own->answer.impacts[impact].after) /
         energy_of(question, question.start);
}

std::optional<std::size_t> DieResult::first_wrong() const {
  constexpr double room = 100;  // each impact is found to the tolerance, not only the first one
  for (std::size_t i = 0; i < truth.t.size(); ++i)
    if (i >= own->answer.impacts.size() || std::abs(late(i)) > room * truth.grown[i]) return i;
  return std::nullopt;
}

DieLaws DieResult::laws() const {
  const RigidBodyState<> start = unpack<double>(question.start);
  const double at_start = energy_of(question, question.start);
  DieLaws laws;
  double before = at_start;
  const auto worse = [](double& largest, double x) { largest = std::max(largest, x); };
  const std::vector<DieImpact>& impacts = own->answer.impacts;
  const std::size_t last = first_wrong().value_or(impacts.size());
  for (std::size_t i = 0; i < std::min(last + 1, impacts.size()); ++i) {
    const RigidBodyState<> after = unpack<double>(impacts[i].after);
    worse(laws.height, std::abs(lowest_corner(impacts[i].after)));
    worse(laws.sideways, (after.P - start.P).head<2>().norm() / start.P.norm());
    worse(laws.sideways, std::abs(after.L.z() - start.L.z()) / start.L.norm());
    const double energy = energy_of(question, impacts[i].after);
    worse(laws.energy, (energy - before) / at_start);
    before = energy;
  }
  return laws;
}

bool DieResult::right() const { return own && !first_wrong(); }

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
