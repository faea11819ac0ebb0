#include "scenes/contact_motion.hpp"
#include "scenes/error_growth.hpp"
#include "scenes/motion_output.hpp"
#include "tumble/body/model.hpp"

namespace tumble::scenes {
namespace {

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
    record["bodies"].push_back(state_json(scene.bodies[i], motions.at(i, t)));
  return record;
}

Json report_json(const SceneBody& body, const SimulationReport& report) {
  return {{"name", body.name},
          {"model", name_of(report.model)},
          {"method", report.method},
          {"why", report.why},
          {"tolerance", report.tolerance},
          {"error_estimate", report.error_estimate},
          {"error_of_small_motion", report.error_of_small_motion},
          {"reached", report.reached()},
          {"runs", report.runs},
          {"steps", report.steps},
          {"rejected", report.rejected},
          {"evaluations", report.evaluations}};
}

Json flights_json(const Scene& scene, const Motions& motions, std::size_t i) {
  const SceneBody& body = scene.bodies[i];
  const ModelChoice choice = model_of_moments(body.body);
  return {{"name", body.name},
          {"model", name_of(choice.model)},
          {"method", flights_method},
          {"why", choice.why},
          {"collides_as", body.shape->as},
          {"missing", body.shape->missing},
          {"flights", motions.contacts->run.flights[i].size()},
          {"hops", motions.contacts->run.hops(i)},
          {"at_the_end", how_it_ended(scene, motions, i)},
          {"reached", complete(*motions.contacts)}};
}

const char* name_of_ending(contact::Ending ending) {
  constexpr const char* names[] = {"time", "all_at_rest", "lasting_contact", "too_many_events"};
  return names[static_cast<int>(ending)];
}

Json impact_json(const Scene& scene, const Motions& motions, const contact::ImpactEvent& impact) {
  return {{"time", motions.start + impact.t},
          {"body", scene.bodies[static_cast<std::size_t>(impact.body)].name},
          {"other", hit_name(scene, impact)},
          {"point", as_json(impact.point)},
          {"normal", as_json(impact.normal)},
          {"impulse", as_json(impact.impulse)},
          {"energy_lost", -impact.energy},
          {"jammed", impact.jammed}};
}

Json growth_json(const Scene& scene, const Motions& motions) {
  const ErrorGrowth growth = error_growth(*motions.contacts);
  Json json = {{"start_differs_by", growth.start},
               {"end_differs_by", growth.distance},
               {"end_turned_by", growth.angle},
               {"bodies", Json::array()}};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyGrowth& of = growth.bodies[i];
    json["bodies"].push_back(
        {{"name", scene.bodies[i].name},
         {"bounces", of.bounces},
         {"factor_per_bounce", of.factor ? Json(*of.factor) : Json()},
         {"means_nothing_after",
          of.means_nothing_after ? Json(motions.start + *of.means_nothing_after) : Json()}});
  }
  return json;
}

Json run_json(const Scene& scene, const Motions& motions) {
  const contact::ContactRun& run = motions.contacts->run;
  Json json = {{"can_touch", true},
               {"ending", name_of_ending(run.ending)},
               {"undecided", nullptr},
               {"impacts", Json::array()},
               {"rest_since", Json::object()},
               {"energy",
                {{"start", run.energy.start},
                 {"lost_in_impacts", 0 - run.energy.impacts},
                 {"lost_in_sliding", 0 - run.energy.sliding},
                 {"lost_when_put_to_rest", 0 - run.energy.settled},
                 {"end", run.energy.end}}},
               {"queries", run.queries}};
  if (run.undecided >= 0)
    json["undecided"] = scene.bodies[static_cast<std::size_t>(run.undecided)].name;
  for (const contact::ImpactEvent& impact : run.impacts)
    json["impacts"].push_back(impact_json(scene, motions, impact));
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    json["rest_since"][scene.bodies[i].name] =
        std::isfinite(run.rest_since[i]) ? Json(motions.start + run.rest_since[i]) : Json();
  json["error_growth"] = growth_json(scene, motions);
  return json;
}

}  // namespace

Json contact_json(const Scene& scene, const Motions& motions) {
  return motions.contacts ? run_json(scene, motions)
                          : Json{{"can_touch", false}, {"impacts", Json::array()}};
}

void write_scene_json(std::ostream& out, const Scene& scene, const Motions& motions,
                      const std::string& file) {
  Json head = {{"scene", file},
               {"from", motions.start},
               {"to", motions.end},
               {"stopped", motions.stopped},
               {"chosen_and_spent", Json::array()}};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    head["chosen_and_spent"].push_back(
        motions.contacts ? flights_json(scene, motions, i)
                         : report_json(scene.bodies[i], motions.trajectories[i].report()));
  out << "{\n" << members_text(head) << ",\n  \"records\": [";
  const char* separator = "\n";
  for (const double t : record_times(scene, motions)) {
    out << separator << deeper(json_text(record_json(scene, motions, t)), 4);
    separator = ",\n";
  }
  Json tail = {{"end", record_json(scene, motions, motions.end)}};
  if (scene.contact) tail.update(contact_json(scene, motions));
  out << "\n  ],\n" << members_text(tail) << "\n}\n";
}

}  // namespace tumble::scenes
