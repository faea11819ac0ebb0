#include <iostream>

#include "scenes/mass_output.hpp"
#include "support/mesh_notes.hpp"
#include "support/terminal.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble::scenes {
namespace {

std::string numbers(std::initializer_list<double> list, int digits = 16) {
  std::string text;
  for (const double x : list)
    text += (text.empty() ? "" : "  ") + (std::isnan(x) ? "-" : support::number(x, digits));
  return text;
}

std::string numbers(const Vec3& v) { return numbers({v.x(), v.y(), v.z()}); }

/// A bound of an error; "-" if there is none.
std::string bound_text(double relative, double size) {
  const double bound = relative * std::abs(size);
  return std::isfinite(bound) ? support::error_number(bound) : "-";
}

void add_inertia(support::Table& table, const std::string& what, const Mat3& I,
                 const std::string& bound) {
  table.add({what + " xx, yy, zz", numbers({I(0, 0), I(1, 1), I(2, 2)}), "kg m²", bound});
  table.add({what + " xy, yz, zx", numbers({I(0, 1), I(1, 2), I(2, 0)}), "kg m²", bound});
}

/// The name of what spoils the integrals, or of anything that was found; of a crossing that is a
/// note, how much counts wrongly.
std::string worst_of(const MassAnswer& found) {
  if (found.findings.empty()) return found.welded > 0 ? "welded" : "";
  for (const MeshDefect& finding : found.findings)
    if (spoils_integrals(finding)) return name_of(finding.kind);
  const MeshDefect& first = found.findings.front();
  std::string text = name_of(first.kind);
  if (first.kind == MeshDefectKind::self_crossing)
    text += ": " + numbers({first.share}, 2) + " ± " + numbers({first.share_uncertainty}, 1);
  return text;
}

using Cells = std::vector<std::string>;

/// A row with six digits of everything, between the cells that come before it and behind it.
void add_row(support::Table& table, Cells row, double volume, const MassProperties& body,
             const Cells& behind) {
  const Mat3& I = body.inertia;
  const Vec3& c = body.centre;
  const auto add = [&row](std::initializer_list<double> list) { row.push_back(numbers(list, 6)); };
  add({volume});
  add({body.mass});
  add({c.x(), c.y(), c.z()});
  add({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(1, 2), I(2, 0)});
  row.insert(row.end(), behind.begin(), behind.end());
  table.add(row);
}

/// A row for each part, and one for the whole.
void print_parts(const MassAnswer& found) {
  if (found.parts.empty()) return;
  support::Table table({"part", "density [kg/m³]", "volume [m³]", "mass [kg]", "centre of mass [m]",
                        "inertia xx, yy, zz, xy, yz, zx [kg m²]"});
  for (const parts::PartMass& part : found.parts)
    add_row(table, {part.name, support::number(part.density, 6)}, volume_of(part), part, {});
  add_row(table, {"the whole", "-"}, found.volume, found.body, {});
  std::cout << support::fitted(table) << '\n';
}

}  // namespace

std::vector<std::string> sentences(const MassAnswer& found) {
  return support::mesh_notes(found.welded, found.findings);
}

void print(const MassAnswer& found, const MassCommand& command) {
  for (const std::string& sentence : sentences(found))
    std::cout << support::fitted(sentence) << '\n';
  if (!found.usable) return;
  print_parts(found);
  const BoundedMassProperties& body = found.body;
  support::Table table({"quantity", "value", "unit", "error below"});
  if (command.is_shell())
    table.add({"area", numbers({found.area}), "m²", "-"});
  else
    table.add(
        {"volume", numbers({found.volume}), "m³", bound_text(found.volume_bound, found.volume)});
  if (command.mass && !command.is_shell() && found.parts.empty())
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

void print_table(const std::vector<MassAnswer>& all) {
  support::Table table({"file", "volume [m³]", "mass [kg]", "centre of mass [m]",
                        "inertia xx, yy, zz, xy, yz, zx [kg m²]", "found"});
  for (const MassAnswer& found : all) {
    const std::string what = worst_of(found);
    if (!found.usable) {
      table.add({found.file, "-", "-", "-", "-", what.empty() ? "refused" : "refused: " + what});
      continue;
    }
    add_row(table, {found.file}, found.volume, found.body, {what});
    for (const parts::PartMass& part : found.parts)
      add_row(table, {found.file + ", " + part.name}, volume_of(part), part, {""});
  }
  std::cout << support::fitted(table);
}

}  // namespace tumble::scenes
