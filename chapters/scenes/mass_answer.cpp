#include "scenes/mass_answer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "scenes/given_density.hpp"
#include "tumble/mass/shell.hpp"
#include "tumble/mesh/read_mesh.hpp"

namespace tumble::scenes {
namespace {

Accuracy accuracy_of(const std::string& name) {
  if (name == "fast") return Accuracy::fast;
  return name == "textbook" ? Accuracy::textbook : Accuracy::tight;
}

/// The mesh with lengths in metres. A quotient by 1000 is the double nearest to what was written.
parts::LabelledMesh in_metres(parts::LabelledMesh mesh, const std::string& unit) {
  if (unit == "m") return mesh;
  for (Vec3& p : mesh.vertices) {
    if (unit == "mm") p /= 1000;
    if (unit == "cm") p /= 100;
    if (unit == "in") p *= 0.0254;
  }
  return mesh;
}

void require_positive(const std::optional<double>& value, const char* what, const char* unit) {
  if (value)
    require(*value > 0 && std::isfinite(*value), "the ", what, ' ', *value, ' ', unit,
            " is not positive and finite");
}

/// Makes a body heavier; the factor rounds, and so does the product.
/// @param factor_error relative
void make_heavier(BoundedMassProperties& body, double factor, double factor_error) {
  body.mass *= factor;
  body.inertia *= factor;
  body.mass_error_bound += factor_error + 2 * detail::unit_roundoff;
  body.inertia_error_bound += factor_error + 2 * detail::unit_roundoff;
}

/// Makes the body as heavy as it was weighed: all its densities grow alike.
void weigh(MassAnswer& answer, double mass) {
  const double factor = mass / answer.body.mass;
  const double error = answer.body.mass_error_bound + detail::unit_roundoff;
  answer.density *= factor;
  for (parts::PartMass& part : answer.parts) {
    make_heavier(part, factor, error);
    part.density *= factor;
  }
  make_heavier(answer.body, factor, error);
  answer.body.mass = mass;
  answer.body.mass_error_bound = 0;
}

void integrate_shell(const MassCommand& command, const PolygonMesh& mesh, MassAnswer& answer) {
  answer.density = command.shell.value_or(1);
  static_cast<MassProperties&>(answer.body) = shells::mass_properties(mesh, answer.density);
  answer.area = shells::area(mesh);
}

crossings::Search search_of(const MassCommand& command) {
  return command.thorough ? crossings::Search::thorough : crossings::Search::usual;
}

/// Notes what was found, and whether integrals mean something in spite of it.
void note(const MassCommand& command, std::vector<MeshDefect> findings, MassAnswer& answer) {
  answer.findings = std::move(findings);
  for (const MeshDefect& finding : answer.findings)
    answer.usable &= command.accept ? !prevents_integrals(finding.kind)
                                    : !spoils_integrals(finding, command.tolerance);
}

void integrate(const MassCommand& command, double density, const PolygonMesh& mesh,
               MassAnswer& answer) {
  note(command, diagnose(mesh, {}, search_of(command)), answer);
  if (!answer.usable) return;
  answer.density = density;
  answer.body = unchecked_mass_properties(mesh, density, accuracy_of(command.accuracy));
  if (!command.accept) require_volume(answer.body);
  answer.volume = answer.body.mass / density;
  answer.volume_bound = answer.body.mass_error_bound + detail::unit_roundoff;
}

void integrate_parts(const MassCommand& command, const parts::Densities& densities,
                     const parts::LabelledMesh& mesh, MassAnswer& answer) {
  const std::vector<parts::Part> all = parts::split(mesh, densities);
  note(command, parts::diagnose(all, {}, search_of(command)), answer);
  if (!answer.usable) return;
  const parts::Assembly body = parts::unchecked_mass_properties(all, accuracy_of(command.accuracy));
  if (!command.accept) parts::require_volumes(body);
  answer.body = body;
  answer.parts = body.parts;
  answer.volume = 0;
  double error = 0;
  for (const parts::PartMass& part : body.parts) {
    const double volume = volume_of(part);
    answer.volume += volume;
    error += std::abs(volume) * (part.mass_error_bound + detail::unit_roundoff);
  }
  const auto additions = static_cast<double>(body.parts.size());
  answer.volume_bound = error / std::abs(answer.volume) + additions * detail::unit_roundoff;
}

}  // namespace

MassAnswer mass_answer(const MassCommand& command, const std::string& file) {
  const GivenDensity density = given_density(command.density);
  require_positive(density.of_all, "density", "kg/m³");
  require_positive(command.mass, "mass", "kg");
  require_positive(command.shell, "surface density", "kg/m²");
  require(command.tolerance >= 0, "the tolerance ", command.tolerance, " is negative");
  require(!command.mass || !density.of_all,
          "there are a mass and a density: give one of them, and the other follows from it");
  const parts::LabelledMesh mesh = in_metres(read_mesh(file), command.unit);
  MassAnswer answer{.file = file, .findings = {}};
  if (command.shell)
    integrate_shell(command, mesh, answer);
  else if (density.of_parts.empty())
    integrate(command, density.of_all.value_or(1), mesh, answer);
  else
    detail::require_at([&] { integrate_parts(command, density.of_parts, mesh, answer); }, file,
                       ": ");
  if (answer.usable && command.mass) weigh(answer, *command.mass);
  return answer;
}

std::vector<std::string> mesh_files(const std::vector<std::string>& given) {
  std::vector<std::string> files;
  for (const std::string& path : given) {
    if (!std::filesystem::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    const std::size_t before = files.size();
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      std::string ending = entry.path().extension().string();
      for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      if (ending == ".obj" || ending == ".stl" || ending == ".ply")
        files.push_back(entry.path().string());
    }
    require(files.size() > before, path, ": no .obj, .stl or .ply file in this folder");
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
  }
  return files;
}

}  // namespace tumble::scenes
