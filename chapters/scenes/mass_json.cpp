#include "scenes/mass_output.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble::scenes {
namespace {

Json finding_json(const MeshDefect& finding, double tolerance) {
  Json json = {{"kind", name_of(finding.kind)}, {"message", finding.message}};
  if (finding.face >= 0) json["face"] = finding.face + 1;
  if (finding.edge[0] >= 0) json["edge"] = {finding.edge[0] + 1, finding.edge[1] + 1};
  if (std::isfinite(finding.share)) {
    json["share"] = finding.share;
    json["share_uncertainty"] = finding.share_uncertainty;
  }
  json["refused"] = spoils_integrals(finding, tolerance);
  return json;
}

/// Mass, centre and inertia with their bounds.
void add_ten_numbers(Json& json, const BoundedMassProperties& body) {
  json["mass"] = body.mass;
  json["centre"] = as_json(body.centre);
  json["centre_rest"] = as_json(body.centre_rest);
  json["inertia"] = as_json(body.inertia);
  json["bounds"] = {{"mass", body.mass_error_bound},
                    {"centre", body.centre_error_bound},
                    {"inertia", body.inertia_error_bound}};
}

Json part_json(const parts::PartMass& part) {
  Json json = {{"name", part.name},
               {"faces", part.faces},
               {"density", part.density},
               {"volume", volume_of(part)}};
  add_ten_numbers(json, part);
  return json;
}

void add_body(Json& json, const MassAnswer& found, const MassCommand& command) {
  const BoundedMassProperties& body = found.body;
  if (command.is_shell())
    json["area"] = found.area;
  else
    json["volume"] = found.volume;
  add_ten_numbers(json, body);
  const PrincipalAxes principal = principal_axes(body.inertia);
  json["principal"] = {{"moments", as_json(principal.moments)},
                       {"orientation", as_json(Quat(principal.R))}};
  if (!command.about.empty())
    json["about"] = {{"point", command.about},
                     {"inertia", as_json(inertia_about(body, point_of(command.about)))}};
}

}  // namespace

Json answer_json(const MassAnswer& found, const MassCommand& command) {
  Json json = {{"file", found.file},
               {command.is_shell() ? "surface_density" : "density", found.density},
               {"accuracy", command.accuracy},
               {"unit", command.unit}};
  for (const char* key : {"volume", "mass", "centre", "centre_rest", "inertia", "bounds"})
    json[key] = nullptr;
  if (found.usable) add_body(json, found, command);
  if (!found.refusal.empty()) json["error"] = found.refusal;
  if (!found.parts.empty()) json["density"] = nullptr;  // it is not the same everywhere
  for (const parts::PartMass& part : found.parts) json["parts"].push_back(part_json(part));
  json["welded"] = found.welded;
  json["findings"] = Json::array();
  for (const MeshDefect& finding : found.findings)
    json["findings"].push_back(finding_json(finding, command.tolerance));
  return json;
}

}  // namespace tumble::scenes
