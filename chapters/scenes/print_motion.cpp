#include <iostream>
#include <sstream>

#include "scenes/contact_motion.hpp"
#include "scenes/motion_output.hpp"
#include "support/terminal.hpp"
#include "tumble/body/model.hpp"

namespace tumble::scenes {
namespace {

std::string nine_digits(const Vec3& v) {
  return support::number(v.x(), 9) + "  " + support::number(v.y(), 9) + "  " +
         support::number(v.z(), 9);
}

template <class... Parts>
void print_line(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  std::cout << support::fitted(text.str()) << '\n';
}

void print_report(const SimulationReport& report) {
  print_line("model: ", name_of(report.model), " (", report.why, ")");
  print_line("method: ", report.method);
  print_line("error: about ", support::error_number(report.error_estimate), "; you asked for ",
             support::error_number(report.tolerance));
  if (report.error_of_small_motion > 0)
    print_line("the motion is small: as a part of itself, the error is about ",
               support::error_number(report.error_of_small_motion));
  print_line("spent: ", report.runs, " runs, ", report.steps, " steps, ", report.evaluations,
             " evaluations");
  std::cout << '\n';
}

void print_flights(const Scene& scene, const Motions& motions, std::size_t i) {
  const BodyShape& shape = *scene.bodies[i].shape;
  print_line("method: ", flights_method);
  print_line("collides as ", shape.as);
  if (shape.missing > 0)
    print_line("the shape reaches at most ", support::number(shape.missing, 2), " m beyond it");
  print_line("at the end: ", support::escaped(how_it_ended(scene, motions, i)));
  std::cout << '\n';
}

void print_end(const Scene& scene, const Motions& motions) {
  std::cout << (motions.stopped ? "stopped at t = " : "until t = ")
            << support::number(motions.end, 9) << " s\n";
  if (scene.stop && !motions.stopped) {
    const StopWhen& stop = *scene.stop;
    std::cout << "stop_when: the "
              << "xyz"[stop.coordinate] << " of " << support::escaped(scene.bodies[stop.body].name)
              << " has not passed " << support::number(stop.level, 6) << " m by then\n";
  }
  if (scene.contact && !motions.contacts) print_line("nothing can touch: no collision code ran");
  std::cout << '\n';
}

}  // namespace

void print_motion(const Scene& scene, const Motions& motions) {
  print_end(scene, motions);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const RigidBodyState<> s = motions.at(i, motions.end);
    const Derived<> now = derived(body.body, s);
    support::Table table({body.name, "at the end", "unit"});
    table.add({"position", nine_digits(s.x), "m"});
    table.add(
        {"orientation (w x y z)", support::number(s.q.w(), 9) + "  " + nine_digits(s.q.vec()), ""});
    table.add({"velocity", nine_digits(now.v), "m/s"});
    table.add({"angular velocity", nine_digits(now.omega), "rad/s"});
    table.add({"linear momentum", nine_digits(s.P), "kg m/s"});
    table.add({"angular momentum", nine_digits(s.L), "kg m²/s"});
    std::cout << support::fitted(table);
    if (motions.contacts)
      print_flights(scene, motions, i);
    else
      print_report(motions.trajectories[i].report());
  }
}

}  // namespace tumble::scenes
