#include <algorithm>

#include "scenes/motion_output.hpp"
#include "support/envelope.hpp"
#include "support/plot.hpp"
#include "support/printable.hpp"

namespace tumble::scenes {
namespace {

/// In body axes, one curve for each.
std::vector<support::Series> spin_curves(const SceneBody& body, const Motions& motions,
                                         std::size_t which, const std::vector<double>& times) {
  std::vector<support::Envelope> curves(3, support::Envelope(times.size()));
  for (const double t : times) {
    const RigidBodyState<> s = motions.at(which, t);
    const Vec3 omega = s.q.conjugate() * derived(body.body, s).omega;
    for (std::size_t k = 0; k < 3; ++k) curves[k].add(t, omega[static_cast<int>(k)]);
  }
  const bool several = motions.trajectories.size() > 1;
  std::vector<support::Series> list;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string axis(1, "xyz"[k]);
    list.push_back({several ? support::escaped(body.name) + " " + axis : "about " + axis, {}, {}});
    curves[k].write_to(list.back());
  }
  return list;
}

}  // namespace

std::string spin_plot(const Scene& scene, const Motions& motions) {
  constexpr std::size_t most = 20;  // curves of more bodies hide each other
  const std::size_t all = scene.bodies.size(), shown = std::min(most, all);
  std::string title = "angular velocity in the body";
  if (shown < all)
    title += ", the first " + std::to_string(shown) + " of " + std::to_string(all) + " bodies";
  support::Plot plot{title,
                     {"time [s]", support::Scale::linear},
                     {"angular velocity [rad/s]", support::Scale::linear},
                     {}};
  const std::vector<double> times = record_times(scene, motions);
  for (std::size_t i = 0; i < shown; ++i)
    for (support::Series& curve : spin_curves(scene.bodies[i], motions, i, times))
      plot.series.push_back(std::move(curve));
  return support::to_svg(plot);
}

}  // namespace tumble::scenes
