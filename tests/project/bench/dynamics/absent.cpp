#include "project/bench/dynamics/absent.hpp"

#include "project/bench/least_times.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"
#include "tumble/steady/steady_path.hpp"

namespace tumble::bench {
namespace {

using support::Table;

constexpr int steps = 200;
constexpr double h = 0.01;

const RigidBody<>& full_body() {
  static const RigidBody<> body(2, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
  return body;
}

RigidBodyState<> thrown() {
  return {Vec3(0, 0, 2), Quat(0.8, 0.2, 0.4, 0.4), Vec3(1, 0, 4), Vec3(1, 2, 0.5)};
}

// ── By hand: somebody who has never heard of forces that can be left out ──

/// Nothing pushes.
PackedState<double> free_by_hand(double, const PackedState<double>& y) {
  const RigidBodyState<> s = unpack<double>(y);
  const Derived<> now = derived(full_body(), s);
  return pack<double>(
      {now.v, rotation::quaternion_dot(s.q, now.omega), Vec3::Zero(), Vec3::Zero()});
}

PackedState<double> falling_by_hand(double, const PackedState<double>& y) {
  const RigidBodyState<> s = unpack<double>(y);
  const Derived<> now = derived(full_body(), s);
  const Vec3 weight = full_body().mass() * Vec3(0, 0, -9.80665);
  return pack<double>({now.v, rotation::quaternion_dot(s.q, now.omega), weight, Vec3::Zero()});
}

// ── Runs ──

template <class Rhs>
std::function<double()> stepping(const Rhs& f) {
  return [f, start = pack(thrown())] {
    return integrate_fixed<Rk4>(f, start, 0.0, steps * h, steps)[3];
  };
}

std::vector<double> measured(const std::vector<std::function<double()>>& runs,
                             const Budget& budget) {
  std::vector<Timed> all;
  for (const auto& run : runs) all.push_back({run, 3 * budget.repetitions, budget.seconds});
  return least_times(all);
}

std::string nanoseconds(double seconds) { return support::number(seconds * 1e9, 3); }

/// As much slower as the scene without a force may be than code that does not know of forces.
constexpr double most = 1.4;

std::string compare_forces(Table& table, const Budget& budget) {
  const BodyDrag drag{0.4, 0.1};
  const SpringToWorld spring{Vec3(0.6, 0, 0.8), Vec3(0, 0, 2), 10, 1};
  const RigidBody<>& body = full_body();
  const std::vector<double> t = measured(
      {stepping(free_by_hand), stepping(RigidBodyRhs(body)), stepping(falling_by_hand),
       stepping(RigidBodyRhs(body, Weight{})), stepping(RigidBodyRhs(body, Weight{}, drag)),
       stepping(RigidBodyRhs(body, Weight{}, drag, spring))},
      budget);
  std::string broken;
  const auto add = [&](const std::string& name, double seconds, double by_hand) {
    table.add({name, nanoseconds(seconds / steps), by_hand > 0 ? nanoseconds(by_hand / steps) : "–",
               by_hand > 0 ? support::number(seconds / by_hand, 3) : "–"});
    if (by_hand > 0 && seconds > most * by_hand)
      broken += "; " + name + " takes " + support::number(seconds / by_hand, 3) +
                " times as long as by hand";
  };
  add("no force", t[1], t[0]);
  add("weight", t[3], t[2]);
  add("weight and drag", t[4], 0);
  add("weight, drag and spring", t[5], 0);
  return broken;
}

/// A free body, set up and asked once, and once more.
struct Asked {
  std::function<double()> first, again;
};

Asked asked(const Vec3& moments) {
  const RigidBody<> body(2, Mat3(moments.asDiagonal()));
  return {[body, start = thrown()] { return FreeTrajectory(body, start).at(1.5).q.w(); },
          [motion = FreeTrajectory(body, thrown())] { return motion.at(1.5).q.w(); }};
}

Asked asked_for_path() {
  const RigidBody<>& body = full_body();
  return {[&body, start = thrown()] {
            return steady::SteadyPath(body, start, Weight{}.steady(body)).x(1.5).z();
          },
          [path = steady::SteadyPath(body, thrown(), Weight{}.steady(body))] {
            return path.x(1.5).z();
          }};
}

void add_rungs(Table& table, const Budget& budget) {
  const std::vector<std::pair<std::string, Asked>> rungs = {
      {"particle, 6 numbers", asked_for_path()},
      {"ball, 13", asked(Vec3(2, 2, 2))},
      {"symmetric top, 13", asked(Vec3(2, 2, 2.5))},
      {"full body, 13", asked(Vec3(1, 2, 2.5))}};
  std::vector<std::function<double()>> runs;
  for (const auto& [name, rung] : rungs) runs.insert(runs.end(), {rung.first, rung.again});
  const std::vector<double> t = measured(runs, budget);
  for (std::size_t i = 0; i < rungs.size(); ++i)
    table.add({rungs[i].first, nanoseconds(t[2 * i]), nanoseconds(t[2 * i + 1])});
}

}  // namespace

Absent absent(const Budget& budget) {
  Absent all{Table({"a step of RK4 with", "ns", "by hand", "ratio"}),
             Table({"closed form of", "ns, set up and asked once", "ns, once more"}),
             {}};
  all.broken = compare_forces(all.forces, budget);
  add_rungs(all.rungs, budget);
  return all;
}

}  // namespace tumble::bench
