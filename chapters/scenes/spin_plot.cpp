#include "scenes/motion_output.hpp"
#include "support/plot.hpp"
#include "support/printable.hpp"

namespace tumble::scenes {

std::string spin_plot(const Scene& scene, const Motions& motions) {
  support::Plot plot{"angular velocity in the body",
                     {"time [s]", support::Scale::linear},
                     {"angular velocity [rad/s]", support::Scale::linear},
                     {}};
  const bool several = scene.bodies.size() > 1;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::string axis(1, "xyz"[k]);
      support::Series series{
          several ? support::escaped(scene.bodies[i].name) + " " + axis : "about " + axis, {}, {}};
      for (const double t : record_times(scene, motions)) {
        const RigidBodyState<> s = motions.at(i, t);
        series.x.push_back(t);
        series.y.push_back((s.q.conjugate() * derived(scene.bodies[i].body, s).omega)[k]);
      }
      plot.series.push_back(series);
    }
  return support::to_svg(plot);
}

}  // namespace tumble::scenes
