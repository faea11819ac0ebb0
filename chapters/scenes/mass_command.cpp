#include <iostream>

#include "scenes/commands.hpp"
#include "scenes/inertial_blocks.hpp"
#include "scenes/json.hpp"
#include "scenes/mass_answer.hpp"
#include "support/terminal.hpp"
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

Vec3 point_of(const std::vector<double>& about) { return {about[0], about[1], about[2]}; }

void add_body(Json& json, const MassAnswer& found, const MassCommand& command) {
  const BoundedMassProperties& body = found.body;
  if (command.shell)
    json["area"] = found.area;
  else
    json["volume"] = found.volume;
  json["mass"] = body.mass;
  json["centre"] = as_json(body.centre);
  json["centre_rest"] = as_json(body.centre_rest);
  json["inertia"] = as_json(body.inertia);
  json["bounds"] = {{"mass", body.mass_error_bound},
                    {"centre", body.centre_error_bound},
                    {"inertia", body.inertia_error_bound}};
  const PrincipalAxes principal = principal_axes(body.inertia);
  json["principal"] = {{"moments", as_json(principal.moments)},
                       {"orientation", as_json(Quat(principal.R))}};
  if (!command.about.empty())
    json["about"] = {{"point", command.about},
                     {"inertia", as_json(inertia_about(body, point_of(command.about)))}};
}

Json answer_json(const MassAnswer& found, const MassCommand& command) {
  Json json = {{"file", found.file},
               {command.shell ? "surface_density" : "density", found.density},
               {"accuracy", command.accuracy},
               {"unit", command.unit}};
  for (const char* key : {"volume", "mass", "centre", "centre_rest", "inertia", "bounds"})
    json[key] = nullptr;
  if (found.usable) add_body(json, found, command);
  json["findings"] = Json::array();
  for (const MeshDefect& finding : found.findings)
    json["findings"].push_back(finding_json(finding, command.tolerance));
  return json;
}

std::string numbers(std::initializer_list<double> list) {
  std::string text;
  for (const double x : list)
    text += (text.empty() ? "" : "  ") + (std::isnan(x) ? "-" : support::number(x, 16));
  return text;
}

std::string numbers(const Vec3& v) { return numbers({v.x(), v.y(), v.z()}); }

/// A bound of an error; "-" if there is none.
std::string bound_text(double relative, double size) {
  const double bound = relative * std::abs(size);
  return std::isfinite(bound) ? support::error_number(bound) : "-";
}

void print_findings(const MassAnswer& found) {
  for (const MeshDefect& finding : found.findings)
    std::cout << support::fitted(std::string(name_of(finding.kind)) + ": " + finding.message)
              << '\n';
}

void add_inertia(support::Table& table, const std::string& what, const Mat3& I,
                 const std::string& bound) {
  table.add({what + " xx, yy, zz", numbers({I(0, 0), I(1, 1), I(2, 2)}), "kg m²", bound});
  table.add({what + " xy, yz, zx", numbers({I(0, 1), I(1, 2), I(2, 0)}), "kg m²", bound});
}

void print(const MassAnswer& found, const MassCommand& command) {
  print_findings(found);
  if (!found.usable) return;
  const BoundedMassProperties& body = found.body;
  support::Table table({"quantity", "value", "unit", "error below"});
  if (command.shell)
    table.add({"area", numbers({found.area}), "m²", "-"});
  else
    table.add(
        {"volume", numbers({found.volume}), "m³", bound_text(found.volume_bound, found.volume)});
  if (command.mass && !command.shell)
    table.add({"density", numbers({found.density}), "kg/m³", "-"});
  table.add({"mass", numbers({body.mass}), "kg", bound_text(body.mass_error_bound, body.mass)});
  table.add({"centre of mass", numbers(body.centre), "m", bound_text(body.centre_error_bound, 1)});
  const std::string bound = bound_text(body.inertia_error_bound, body.inertia.norm());
  add_inertia(table, "inertia", body.inertia, bound);
  const PrincipalAxes principal = principal_axes(body.inertia);
  table.add({"principal moments", numbers(principal.moments), "kg m²", bound});
  for (int k = 0; k < 3; ++k)
    table.add(
        {"principal axis " + std::to_string(k + 1), numbers(Vec3(principal.R.col(k))), "", "-"});
  if (!command.about.empty())
    add_inertia(table, "about the point", inertia_about(body, point_of(command.about)), "-");
  std::cout << support::fitted(table);
}

/// The name of what spoils the integrals, or of anything that was found.
std::string worst_of(const std::vector<MeshDefect>& findings) {
  for (const MeshDefect& finding : findings)
    if (spoils_integrals(finding)) return name_of(finding.kind);
  return findings.empty() ? "" : name_of(findings.front().kind);
}

/// Several files, one line each.
void print_table(const std::vector<MassAnswer>& all) {
  support::Table table({"file", "volume [m³]", "mass [kg]", "centre of mass [m]",
                        "inertia xx, yy, zz, xy, yz, zx [kg m²]", "found"});
  const auto list = [](std::initializer_list<double> values) {
    std::string text;
    for (const double x : values) text += (text.empty() ? "" : "  ") + support::number(x, 6);
    return text;
  };
  for (const MassAnswer& found : all) {
    const Mat3& I = found.body.inertia;
    const Vec3& c = found.body.centre;
    const std::string what = worst_of(found.findings);
    if (!found.usable) {
      table.add({found.file, "-", "-", "-", "-", "refused: " + what});
      continue;
    }
    table.add({found.file, std::isnan(found.volume) ? "-" : list({found.volume}),
               list({found.body.mass}), list({c.x(), c.y(), c.z()}),
               list({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(1, 2), I(2, 0)}), what});
  }
  std::cout << support::fitted(table);
}

void print_all(const std::vector<MassAnswer>& all, const MassCommand& command) {
  if (command.json) {
    Json list = Json::array();
    for (const MassAnswer& found : all) list.push_back(answer_json(found, command));
    std::cout << (all.size() == 1 ? list[0] : list).dump(2) << '\n';
  } else if (!command.block.empty()) {
    for (const MassAnswer& found : all) {
      if (all.size() > 1) std::cout << "<!-- " << found.file << " -->\n";
      if (found.usable) std::cout << inertial_block(command.block, found.body);
    }
  } else if (all.size() > 1) {
    print_table(all);
  } else {
    print(all[0], command);
  }
}

}  // namespace

int run(const MassCommand& command) {
  std::vector<MassAnswer> all;
  for (const std::string& file : mesh_files(command.files))
    all.push_back(mass_answer(command, file));
  print_all(all, command);
  int status = 0;
  for (const MassAnswer& found : all) {
    if (found.usable) continue;
    status = 1;
    if (!command.block.empty())
      for (const MeshDefect& finding : found.findings)
        std::cerr << name_of(finding.kind) << ": " << finding.message << '\n';
    std::cerr << "tumble: " << found.file << ": not the boundary of a body, see above"
              << (command.accept ? "" : "; --accept computes what can be computed") << '\n';
  }
  return status;
}

}  // namespace tumble::scenes
