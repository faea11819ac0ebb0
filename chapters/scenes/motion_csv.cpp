#include <sstream>

#include "scenes/contact_motion.hpp"
#include "scenes/motion_output.hpp"
#include "support/csv.hpp"
#include "support/shortest.hpp"
#include "tumble/simulate/write_states.hpp"

namespace tumble::scenes {
namespace {

using support::shortest;

void add(std::ostringstream& csv, const Vec3& v) {
  for (const double x : v) csv << ',' << shortest(x);
}

}  // namespace

void write_states_csv(std::ostream& csv, const Scene& scene, const Motions& motions) {
  csv << "time,body," << output::csv_columns << '\n';
  for (const double t : record_times(scene, motions))
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      csv << shortest(t) << ',' << support::csv_field(scene.bodies[i].name) << ',';
      detail::write_csv_numbers(csv, scene.bodies[i].body, motions.at(i, t));
      csv << '\n';
    }
}

std::string impacts_csv(const Scene& scene, const Motions& motions) {
  std::ostringstream csv;
  csv << "time,body,other,x,y,z,nx,ny,nz,jx,jy,jz,energy_lost\n";
  if (!motions.contacts) return csv.str();
  for (const contact::ImpactEvent& impact : motions.contacts->run.impacts) {
    const std::string& body = scene.bodies[static_cast<std::size_t>(impact.body)].name;
    csv << shortest(motions.start + impact.t) << ',' << support::csv_field(body) << ','
        << support::csv_field(hit_name(scene, impact));
    for (const Vec3& v : {impact.point, impact.normal, impact.impulse}) add(csv, v);
    csv << ',' << shortest(-impact.energy) << '\n';
  }
  return csv.str();
}

}  // namespace tumble::scenes
