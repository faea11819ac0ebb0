/// @file
/// Friction during the impact: one rod, a thousand impacts, and Painlevé's rod.

#include <algorithm>
#include <array>

#include "common.hpp"
#include "laws.hpp"
#include "parts.hpp"

namespace contact_chapter {

namespace {

struct Law {
  std::string name;
  PlanarResult (*of)(const PlanarImpact&);
};

const std::array<Law, 3> laws{{{"tutorials: Newton", usual_law},
                               {"slip followed: Poisson", poisson_law},
                               {"slip followed: Stronge", stronge_law}}};

/// A body of 1 kg and inertia 1 kg m² that is hit somewhere, with u_n < 0.
PlanarImpact random_impact(support::Random& random) {
  const double angle = random.uniform(0, 2 * pi), reach = random.uniform(0.2, 3);
  const Vec2 turning = reach * Vec2(std::cos(angle), std::sin(angle));
  const double slip = random.uniform(), e = random.uniform(0, 1), mu = random.uniform(0, 1);
  return {
      Mat2::Identity() + turning * turning.transpose(), {slip, -random.uniform(0.05, 1)}, e, mu};
}

}  // namespace

Table rod_table() {
  Table table({"law", "impulse [N s]", "velocity after [m/s]", "of ½ uᵀK⁻¹u", "of ½ m u²"});
  const PlanarImpact rod = hook_rod();
  const auto pair = [](const Vec2& v) {
    return "(" + rounded(v.x()) + ", " + rounded(v.y()) + ")";
  };
  for (const Law& law : laws) {
    const PlanarResult after = law.of(rod);
    const double change = energy_change(rod, after);
    table.add({law.name, pair(after.impulse), pair(after.u), percent(change / energy_at_stake(rod)),
               percent(change / (rod.u.squaredNorm() / 2))});
  }
  return table;
}

Table laws_table() {
  Table table({"law", "gain energy", "worst, of ½ uᵀK⁻¹u", "normal gives more than it took"});
  for (const Law& law : laws) {
    support::Random random(1);
    int gains = 0, normal_gains = 0;
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
      const PlanarImpact impact = random_impact(random);
      const PlanarResult after = law.of(impact);
      const double gain = energy_change(impact, after) / energy_at_stake(impact);
      if (ContactPath(impact).taken(after.impulse.y()) < -1e-9) ++normal_gains;
      if (gain > 1e-9) ++gains;
      worst = std::max(worst, gain);
    }
    table.add({law.name, std::to_string(gains), worst < 1e-9 ? "none" : percent(worst),
               std::to_string(normal_gains)});
  }
  return table;
}

Table painleve_table() {
  constexpr double mu = 1.5;
  Table table({"angle", "K_nn", "|K_nt|", "jams from μ =", "K_nn − 1.5 |K_nt|", "jams at μ = 1.5"});
  for (const double angle : {20., 30., 40., 50., 60., std::atan(2.) / degree, 70., 80.}) {
    const Mat2 K = tip_of_rod(angle * degree);
    // The slip that presses: friction against it pushes the tip down.
    const PlanarImpact impact{K, {std::copysign(1, K(0, 1)), -0.1}, 0, mu};
    table.add({rounded(angle, 1) + "°", rounded(K(1, 1)), rounded(std::abs(K(0, 1))),
               rounded(K(1, 1) / std::abs(K(0, 1))), rounded(K(1, 1) - mu * std::abs(K(0, 1))),
               yes_or_no(contact::collide_with_friction(in_space(impact)).jammed)});
  }
  return table;
}

// ── The slip over the normal impulse ──

namespace {

struct SlipCurves {
  Series slip, normal;

  void add(double p, const Vec2& u) {
    slip.x.push_back(p), slip.y.push_back(u.x());
    normal.x.push_back(p), normal.y.push_back(u.y());
  }
};

/// The law that follows the slip.
SlipCurves followed_slip(const PlanarImpact& rod) {
  SlipCurves curves{{"u_t, followed", {}, {}, support::Look::line, "c0", 2.4},
                    {"u_n, followed", {}, {}, support::Look::line, "c2", 2.4}};
  const ContactPath path(rod);
  const double end = stronge_law(rod).impulse.y();
  for (const double p : {0., path.rest(), path.closest(), end}) curves.add(p, path.velocity(p));
  return curves;
}

/// The usual law: friction against the slip of the start, to the end.
SlipCurves usual_slip(const PlanarImpact& rod) {
  SlipCurves curves{{"u_t, tutorials", {}, {}, support::Look::dashed, "c0", 1.8},
                    {"u_n, tutorials", {}, {}, support::Look::dashed, "c2", 1.8}};
  const PlanarResult after = usual_law(rod);
  curves.add(0, rod.u);
  curves.add(after.impulse.y(), after.u);
  return curves;
}

}  // namespace

std::string slip_figure() {
  const PlanarImpact rod = hook_rod();
  const SlipCurves ours = followed_slip(rod), usual = usual_slip(rod);
  const Series turn{"turns", {ContactPath(rod).rest()}, {0}, support::Look::dots, "c6"};
  Plot plot{"during the impact", {"normal impulse p [N s]"}, {"velocity of the tip [m/s]"}, {}};
  plot.series = {ours.slip, ours.normal, usual.slip, usual.normal, turn};
  return support::to_svg(plot);
}

}  // namespace contact_chapter
