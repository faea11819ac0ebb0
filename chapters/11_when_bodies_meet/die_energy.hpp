#pragma once
/// @file
/// The energy of a thrown die over time, drawn: of its height, of its motion, of its turning.

#include <string>
#include <vector>

#include "11_when_bodies_meet/thrown_die.hpp"
#include "support/sketch.hpp"

namespace contact_chapter {

/// What the die has at a time, each above the one before [mJ].
struct Energies {
  double t, turning, moving, all;
};

inline Energies energies_at(const Throw& thrown, const SteadyFlight& flight, double t) {
  constexpr double milli = 1e3;
  const RigidBodyState<> state = flight.state(t);
  const double mass = thrown.body.mass(),
               turning = state.L.squaredNorm() / thrown.body.I_body()(0, 0) / 2,
               moving = state.P.squaredNorm() / mass / 2,
               height = mass * die_gravity * (state.x.z() - die_edge / 2);
  return {t, milli * turning, milli * (turning + moving), milli * (turning + moving + height)};
}

inline std::vector<Energies> energies_of(const Throw& thrown) {
  constexpr double fine = 0.008;  // [s]
  std::vector<Energies> all;
  const auto& legs = thrown.legs();
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double begin = legs[i].t, end = i + 1 < legs.size() ? legs[i + 1].t : thrown.run.t;
    const int parts = 1 + static_cast<int>((end - begin) / fine);
    const bool rests = legs[i].on_wall >= 0 && thrown.flight(legs[i]).is_still();
    for (int k = 0; k <= parts && !rests; ++k)
      all.push_back(energies_at(thrown, thrown.flight(legs[i]), begin + k * (end - begin) / parts));
  }
  return all;
}

constexpr double strip_left = 80, strip_bottom = 575, per_second = 640, per_millijoule = 21;

/// What lies between two of the curves.
inline void draw_band(support::Sketch& sketch, const std::vector<Energies>& all,
                      double Energies::*low, double Energies::*high, const std::string& colour) {
  std::vector<Eigen::Vector2d> band;
  for (const Energies& each : all)
    band.emplace_back(per_second * each.t, per_millijoule * each.*high);
  for (auto each = all.rbegin(); each != all.rend(); ++each)
    band.emplace_back(per_second * each->t, low ? per_millijoule * (*each).*low : 0);
  sketch.curve(band, {colour, 0.6, 1, 0.45});
}

/// @param longest how far the axis of time goes [s]
/// @param t        the moment that is shown
inline void draw_energy(support::Sketch& sketch, const Throw& thrown, double longest, double t) {
  const std::vector<Energies> all = energies_of(thrown);
  sketch.look({strip_left, strip_bottom, 1});
  draw_band(sketch, all, &Energies::moving, &Energies::all, "c2");
  draw_band(sketch, all, &Energies::turning, &Energies::moving, "c0");
  draw_band(sketch, all, nullptr, &Energies::turning, "c1");
  sketch.curve({{0, 0}, {per_second * longest, 0}}, {"faint", 1});
  std::vector<std::vector<Eigen::Vector2d>> marks;
  for (const contact::ImpactEvent& impact : thrown.run.impacts)
    marks.push_back({{per_second * impact.t, -9}, {per_second * impact.t, 0}});
  sketch.curves(marks, {"c6", 1.2});
  for (const double tick : {0.2, 0.4, 0.6, 0.8, 1.0})
    sketch.words({per_second * tick * longest, 0}, {0, 27},
                 support::svg_number(tick * longest, 1) + (tick < 1 ? "" : " s"), "faint",
                 "middle");
  sketch.curve({{per_second * t, -12}, {per_second * t, 150}}, {"ink", 1.2});
  sketch.words({0, per_millijoule * all[0].all}, {-6, 6},
               support::svg_number(all[0].all, 1) + " mJ", "ink", "end");
  const double right = per_second * longest - 10;  // clear of the line at the end
  sketch.words({right, 140}, {0, 0}, "energy: height", "c2", "end");
  sketch.words({right, 117}, {0, 0}, "moving", "c0", "end");
  sketch.words({right, 94}, {0, 0}, "turning", "c1", "end");
  sketch.words({right, 60}, {0, 0}, "impacts", "c6", "end");
}

}  // namespace contact_chapter
