#include <iostream>

#include "scenes/commands.hpp"
#include "scenes/json.hpp"
#include "scenes/scene.hpp"
#include "support/csv.hpp"
#include "support/plot.hpp"
#include "support/terminal.hpp"
#include "support/text_file.hpp"
#include "tumble/simulate/first_event.hpp"

namespace tumble::scenes {
namespace {

/// The motions of all bodies, up to the end or to where the scene is stopped.
struct Motions {
  std::vector<Trajectory> trajectories;
  double end;  ///< [s]
  bool stopped = false;
};

Trajectory motion_of(const SceneBody& body, const SimulationTask& task) {
  const auto simulated = [&](const auto&... forces) {
    return body.held ? simulate(*body.held, body.start, task, forces...)
                     : simulate(body.body, body.start, task, forces...);
  };
  if (body.springs.empty()) return simulated(body.steady);
  const auto springs = [list = body.springs](double t, const RigidBody<>& b,
                                             const Derived<>& now) -> Wrench<> {
    Wrench<> sum;
    for (const SpringToWorld& spring : list) sum += spring(t, b, now);
    return sum;
  };
  return simulated(body.steady, springs);
}

Motions move(const Scene& scene) {
  Motions motions{{}, scene.task.t1};
  for (const SceneBody& body : scene.bodies) {
    try {
      motions.trajectories.push_back(motion_of(body, scene.task));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(body.name + ": " + error.what());
    }
  }
  if (!scene.stop) return motions;
  const StopWhen& stop = *scene.stop;
  const auto height = [&](double, const RigidBodyState<>& s) {
    return s.x[stop.coordinate] - stop.level;
  };
  if (const auto event = first_event(motions.trajectories[stop.body], height)) {
    motions.end = event->t;
    motions.stopped = true;
  }
  return motions;
}

/// When states are recorded, the last time at the end.
std::vector<double> times_of(const Scene& scene, double end) {
  std::vector<double> times;
  for (int i = 0; scene.every > 0; ++i) {
    const double t = scene.task.t0 + i * scene.every;
    if (t >= end - 1e-9 * scene.every) break;
    times.push_back(t);
  }
  times.push_back(end);
  return times;
}

Json state_json(const SceneBody& body, const RigidBodyState<>& state) {
  const Derived<> now = derived(body.body, state);
  return {{"name", body.name},
          {"position", as_json(state.x)},
          {"orientation", as_json(state.q)},
          {"velocity", as_json(now.v)},
          {"omega", as_json(now.omega)},
          {"linear_momentum", as_json(state.P)},
          {"angular_momentum", as_json(state.L)}};
}

Json record_json(const Scene& scene, const Motions& motions, double t) {
  Json record = {{"time", t}, {"bodies", Json::array()}};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    record["bodies"].push_back(state_json(scene.bodies[i], motions.trajectories[i].at(t)));
  return record;
}

Json report_json(const SceneBody& body, const SimulationReport& report) {
  return {{"name", body.name},
          {"model", name_of(report.model)},
          {"method", report.method},
          {"why", report.why},
          {"tolerance", report.tolerance},
          {"error_estimate", report.error_estimate},
          {"reached", report.reached()},
          {"runs", report.runs},
          {"steps", report.steps},
          {"rejected", report.rejected},
          {"evaluations", report.evaluations}};
}

Json scene_json(const Scene& scene, const Motions& motions, const SimulateCommand& command) {
  Json json = {{"scene", command.file},
               {"from", scene.task.t0},
               {"to", motions.end},
               {"stopped", motions.stopped},
               {"chosen_and_spent", Json::array()},
               {"records", Json::array()}};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    json["chosen_and_spent"].push_back(
        report_json(scene.bodies[i], motions.trajectories[i].report()));
  for (const double t : times_of(scene, motions.end))
    json["records"].push_back(record_json(scene, motions, t));
  json["end"] = record_json(scene, motions, motions.end);
  return json;
}

/// One line per time and body.
std::string to_csv(const Scene& scene, const Motions& motions) {
  std::ostringstream csv;
  csv.precision(17);
  csv << "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,omega_x,omega_y,omega_z,Px,Py,Pz,Lx,Ly,Lz\n";
  for (const double t : times_of(scene, motions.end))
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const RigidBodyState<> s = motions.trajectories[i].at(t);
      const Derived<> now = derived(scene.bodies[i].body, s);
      csv << t << ',' << support::csv_field(scene.bodies[i].name);
      csv << ',' << s.x.x() << ',' << s.x.y() << ',' << s.x.z();
      csv << ',' << s.q.w() << ',' << s.q.x() << ',' << s.q.y() << ',' << s.q.z();
      for (const Vec3& v : {now.v, now.omega, s.P, s.L})
        csv << ',' << v.x() << ',' << v.y() << ',' << v.z();
      csv << '\n';
    }
  return csv.str();
}

/// How each body turns about its own axes over time.
std::string to_svg(const Scene& scene, const Motions& motions) {
  support::Plot plot{"angular velocity in the body",
                     {"time [s]", support::Scale::linear},
                     {"angular velocity [rad/s]", support::Scale::linear},
                     {}};
  const bool several = scene.bodies.size() > 1;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::string axis(1, "xyz"[k]);
      support::Series series{several ? scene.bodies[i].name + " " + axis : "about " + axis, {}, {}};
      for (const double t : times_of(scene, motions.end)) {
        const RigidBodyState<> s = motions.trajectories[i].at(t);
        series.x.push_back(t);
        series.y.push_back((s.q.conjugate() * derived(scene.bodies[i].body, s).omega)[k]);
      }
      plot.series.push_back(series);
    }
  return support::to_svg(plot);
}

std::string three(const Vec3& v) {
  return support::number(v.x(), 9) + "  " + support::number(v.y(), 9) + "  " +
         support::number(v.z(), 9);
}

void print_report(const SimulationReport& report) {
  const auto line = [](const auto&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    std::cout << support::fitted(text.str()) << '\n';
  };
  line("model: ", name_of(report.model), " (", report.why, ")");
  line("method: ", report.method);
  line("error: about ", support::error_number(report.error_estimate), "; you asked for ",
       support::error_number(report.tolerance));
  line("spent: ", report.runs, " runs, ", report.steps, " steps, ", report.evaluations,
       " evaluations");
  std::cout << '\n';
}

void print(const Scene& scene, const Motions& motions) {
  std::cout << (motions.stopped ? "stopped at t = " : "until t = ")
            << support::number(motions.end, 16) << " s\n";
  if (scene.stop && !motions.stopped) {
    const StopWhen& stop = *scene.stop;
    std::cout << "stop_when: the "
              << "xyz"[stop.coordinate] << " of " << scene.bodies[stop.body].name
              << " has not passed " << support::number(stop.level, 6) << " m by then\n";
  }
  std::cout << '\n';
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const RigidBodyState<> s = motions.trajectories[i].at(motions.end);
    const Derived<> now = derived(body.body, s);
    const SimulationReport& report = motions.trajectories[i].report();
    support::Table table({body.name, "at the end", "unit"});
    table.add({"position", three(s.x), "m"});
    table.add({"orientation (w x y z)", support::number(s.q.w(), 9) + "  " + three(s.q.vec()), ""});
    table.add({"velocity", three(now.v), "m/s"});
    table.add({"angular velocity", three(now.omega), "rad/s"});
    table.add({"linear momentum", three(s.P), "kg m/s"});
    table.add({"angular momentum", three(s.L), "kg m²/s"});
    std::cout << support::fitted(table);
    print_report(report);
  }
}

}  // namespace

int run(const SimulateCommand& command) {
  const Scene scene = read_scene(command.file);
  const Motions motions = move(scene);
  if (!command.csv.empty()) support::write_text(command.csv, to_csv(scene, motions));
  if (!command.svg.empty()) support::write_text(command.svg, to_svg(scene, motions));
  if (command.json)
    std::cout << scene_json(scene, motions, command).dump(2) << '\n';
  else
    print(scene, motions);
  bool reached = true;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SimulationReport& report = motions.trajectories[i].report();
    if (report.reached()) continue;
    std::cerr << "tumble: " << scene.bodies[i].name << ": your tolerance " << report.tolerance
              << " was not reached. The error is about " << report.error_estimate << '\n';
    reached = false;
  }
  return reached ? 0 : 1;
}

}  // namespace tumble::scenes
