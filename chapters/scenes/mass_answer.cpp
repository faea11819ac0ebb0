#include "scenes/mass_answer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "tumble/mass/shell.hpp"
#include "tumble/mesh/read_mesh.hpp"

namespace tumble::scenes {
namespace {

Accuracy accuracy_of(const std::string& name) {
  if (name == "fast") return Accuracy::fast;
  return name == "textbook" ? Accuracy::textbook : Accuracy::tight;
}

/// The mesh with lengths in metres. A quotient by 1000 is the double nearest to what was written.
PolygonMesh in_metres(PolygonMesh mesh, const std::string& unit) {
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

/// Makes the body as heavy as it was weighed; the factor rounds once more, and so does the product.
void weigh(MassAnswer& answer, double mass) {
  const double factor = mass / answer.body.mass;
  answer.density *= factor;
  answer.body.mass = mass;
  answer.body.inertia *= factor;
  answer.body.inertia_error_bound += answer.body.mass_error_bound + 3 * detail::unit_roundoff;
  answer.body.mass_error_bound = 0;
}

void integrate_shell(const MassCommand& command, const PolygonMesh& mesh, MassAnswer& answer) {
  answer.density = command.shell.value_or(1);
  static_cast<MassProperties&>(answer.body) = shells::mass_properties(mesh, answer.density);
  answer.area = shells::area(mesh);
}

void integrate(const MassCommand& command, const PolygonMesh& mesh, MassAnswer& answer) {
  const auto search = command.thorough ? crossings::Search::thorough : crossings::Search::usual;
  answer.findings = diagnose(mesh, {}, search);
  for (const MeshDefect& finding : answer.findings)
    answer.usable &= command.accept ? !prevents_integrals(finding.kind)
                                    : !spoils_integrals(finding, command.tolerance);
  if (!answer.usable) return;
  answer.density = command.density.value_or(1);
  answer.body = unchecked_mass_properties(mesh, answer.density, accuracy_of(command.accuracy));
  if (!command.accept) require_volume(answer.body);
  answer.volume = answer.body.mass / answer.density;
  answer.volume_bound = answer.body.mass_error_bound + detail::unit_roundoff;
}

}  // namespace

MassAnswer mass_answer(const MassCommand& command, const std::string& file) {
  require_positive(command.density, "density", "kg/m³");
  require_positive(command.mass, "mass", "kg");
  require_positive(command.shell, "surface density", "kg/m²");
  require(command.tolerance >= 0, "the tolerance ", command.tolerance, " is negative");
  const PolygonMesh mesh = in_metres(read_mesh(file), command.unit);
  MassAnswer answer{.file = file, .findings = {}};
  command.shell ? integrate_shell(command, mesh, answer) : integrate(command, mesh, answer);
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
