/// @file
/// Two particles as one column of numbers.

#include <string>
#include <vector>

#include "hanging_net.hpp"
#include "parts.hpp"
#include "tumble/particles.hpp"

namespace particles_chapter {

using namespace tumble;
using support::number;

Table state_table() {
  const std::vector<particles::Particle<double>> particles{{0.5, Vec3(1, 2, 3), Vec3(-4, 0, 9)},
                                                           {2.0, Vec3(0, 7, 1), Vec3(5, -6, 0)}};
  const Eigen::VectorXd y = particles::flatten(particles);
  Table table({"places in y", "hold", "here"});
  const auto add = [&](int place, const std::string& what) {
    table.add({number(place) + ", " + number(place + 1) + ", " + number(place + 2), what,
               number(y[place]) + ", " + number(y[place + 1]) + ", " + number(y[place + 2])});
  };
  add(0, "x of particle 0 [m]");
  add(3, "v of particle 0 [m/s]");
  add(6, "x of particle 1 [m]");
  add(9, "v of particle 1 [m/s]");
  return table;
}

}  // namespace particles_chapter
