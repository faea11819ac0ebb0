#include <iostream>

#include "scenes/commands.hpp"
#include "scenes/json.hpp"
#include "support/terminal.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mesh/read_mesh.hpp"

namespace tumble::scenes {
namespace {

/// What can be said about a mesh: the numbers only if there is a body.
struct Answer {
  std::vector<MeshDefect> findings;
  bool usable = true;
  BoundedMassProperties body;
};

Accuracy accuracy_of(const std::string& name) {
  if (name == "fast") return Accuracy::fast;
  return name == "textbook" ? Accuracy::textbook : Accuracy::tight;
}

Answer answer(const MassCommand& command, const PolygonMesh& mesh) {
  require_density(command.density);
  Answer result{diagnose(mesh), true, {}};
  for (const MeshDefect& finding : result.findings)
    result.usable &=
        command.accept ? !prevents_integrals(finding.kind) : !spoils_integrals(finding);
  if (!result.usable) return result;
  result.body = unchecked_mass_properties(mesh, command.density, accuracy_of(command.accuracy));
  if (!command.accept) require_volume(result.body);
  return result;
}

Json finding_json(const MeshDefect& finding) {
  Json json = {{"kind", name_of(finding.kind)}, {"message", finding.message}};
  if (finding.face >= 0) json["face"] = finding.face + 1;
  if (finding.edge[0] >= 0) json["edge"] = {finding.edge[0] + 1, finding.edge[1] + 1};
  json["refused"] = spoils_integrals(finding);
  return json;
}

Json answer_json(const Answer& found, const MassCommand& command) {
  Json json = {
      {"file", command.file}, {"density", command.density}, {"accuracy", command.accuracy}};
  for (const char* key : {"volume", "mass", "centre", "centre_rest", "inertia", "bounds"})
    json[key] = nullptr;
  if (found.usable) {
    const BoundedMassProperties& body = found.body;
    json["volume"] = body.mass / command.density;
    json["mass"] = body.mass;
    json["centre"] = as_json(body.centre);
    json["centre_rest"] = as_json(body.centre_rest);
    json["inertia"] = as_json(body.inertia);
    json["bounds"] = {{"mass", body.mass_error_bound},
                      {"centre", body.centre_error_bound},
                      {"inertia", body.inertia_error_bound}};
  }
  json["findings"] = Json::array();
  for (const MeshDefect& finding : found.findings)
    json["findings"].push_back(finding_json(finding));
  return json;
}

std::string numbers(std::initializer_list<double> list) {
  std::string text;
  for (const double x : list) text += (text.empty() ? "" : "  ") + support::number(x, 16);
  return text;
}

void print(const Answer& found, const MassCommand& command) {
  for (const MeshDefect& finding : found.findings)
    std::cout << support::fitted(std::string(name_of(finding.kind)) + ": " + finding.message)
              << '\n';
  if (!found.usable) return;
  const BoundedMassProperties& body = found.body;
  const Mat3& I = body.inertia;
  support::Table table({"quantity", "value", "unit", "error below"});
  table.add({"volume", numbers({body.mass / command.density}), "m³",
             support::error_number(body.mass_error_bound * body.mass / command.density)});
  table.add({"mass", numbers({body.mass}), "kg",
             support::error_number(body.mass_error_bound * body.mass)});
  table.add({"centre of mass", numbers({body.centre.x(), body.centre.y(), body.centre.z()}), "m",
             support::error_number(body.centre_error_bound)});
  table.add({"inertia xx, yy, zz", numbers({I(0, 0), I(1, 1), I(2, 2)}), "kg m²",
             support::error_number(body.inertia_error_bound * I.norm())});
  table.add({"inertia xy, yz, zx", numbers({I(0, 1), I(1, 2), I(2, 0)}), "kg m²",
             support::error_number(body.inertia_error_bound * I.norm())});
  std::cout << support::fitted(table);
}

}  // namespace

int run(const MassCommand& command) {
  const PolygonMesh mesh = read_mesh(command.file);
  const Answer found = answer(command, mesh);
  if (command.json)
    std::cout << answer_json(found, command).dump(2) << '\n';
  else
    print(found, command);
  if (!found.usable)
    std::cerr << "tumble: " << command.file << ": not the boundary of a body, see above"
              << (command.accept ? "" : "; --accept computes what can be computed") << '\n';
  return found.usable ? 0 : 1;
}

}  // namespace tumble::scenes
