#include "scenes/mass_answer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "scenes/given_density.hpp"
#include "scenes/mass_output.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/mass/shell.hpp"
#include "tumble/mesh/read_mesh.hpp"

namespace tumble::scenes {
namespace {

Accuracy accuracy_of(const std::string& name) {
  if (name == "fast") return Accuracy::fast;
  return name == "textbook" ? Accuracy::textbook : Accuracy::tight;
}

/// A length in metres: rounded once more, so what counts decimals asks the numbers of the file.
template <class Length>
Length in_metres(const Length& x, const std::string& unit) {
  if (unit == "mm") return x / 1000;
  if (unit == "cm") return x / 100;
  if (unit == "in") return x * 0.0254;
  return x;
}

/// A mesh with lengths in metres, which knows how they were written.
struct ReadMesh {
  parts::LabelledMesh mesh;
  std::vector<Vec3> as_written;  ///< the vertices in the unit of the file, if it is not the metre

  ReadMesh(const std::string& file, const std::string& unit) : mesh(read_mesh(file)) {
    if (unit == "m") return;
    as_written = mesh.vertices;
    for (Vec3& p : mesh.vertices) p = in_metres<Vec3>(p, unit);
  }
};

/// What `diagnosed` finds if it is told how far coordinates were rounded when they were written. In
/// metres they have more digits than in the file: where something crosses, the file is asked.
template <class Diagnosed>
std::vector<MeshDefect> findings_of(const ReadMesh& read, const std::string& unit,
                                    const Diagnosed& diagnosed) {
  std::vector<MeshDefect> findings = diagnosed(std::optional<double>{});
  const bool crosses = std::any_of(findings.begin(), findings.end(), [](const MeshDefect& finding) {
    return finding.kind == MeshDefectKind::self_crossing ||
           finding.kind == MeshDefectKind::nested_wrong;
  });
  if (!crosses || read.as_written.empty()) return findings;
  return diagnosed(std::optional(in_metres(detail::coordinate_rounding(read.as_written), unit)));
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
  detail::require_normal(answer.body, "weighed body");
}

/// The mass of a unit of area [kg/m²].
double surface_density(const MassCommand& command, const std::optional<double>& density) {
  if (command.shell) return *command.shell;
  return density.value_or(1) * in_metres(*command.thickness, command.unit);
}

void integrate_shell(double surface_density, const PolygonMesh& mesh, MassAnswer& answer) {
  answer.density = surface_density;
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

void integrate(const MassCommand& command, double density, const ReadMesh& read,
               MassAnswer& answer) {
  const PolygonMesh& mesh = read.mesh;
  const auto diagnosed = [&](std::optional<double> rounding) {
    return diagnose(mesh, {}, search_of(command), rounding);
  };
  note(command, findings_of(read, command.unit, diagnosed), answer);
  if (!answer.usable) return;
  answer.density = density;
  answer.body = unchecked_mass_properties(mesh, density, accuracy_of(command.accuracy));
  if (!command.accept) require_volume(answer.body);
  answer.volume = answer.body.mass / density;
  answer.volume_bound = answer.body.mass_error_bound + detail::unit_roundoff;
}

void integrate_parts(const MassCommand& command, const parts::Densities& densities,
                     const ReadMesh& read, MassAnswer& answer) {
  const std::vector<parts::Part> all = parts::split(read.mesh, densities);
  const auto diagnosed = [&](std::optional<double> rounding) {
    return parts::diagnose(all, {}, search_of(command), rounding);
  };
  note(command, findings_of(read, command.unit, diagnosed), answer);
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

/// @throws std::invalid_argument if a number that was given means nothing, or numbers contradict
///         each other
void require_meaning(const MassCommand& command, const GivenDensity& density) {
  require_positive(density.of_all, "density", "kg/m³");
  require_positive(command.mass, "mass", "kg");
  require_positive(command.shell, "surface density", "kg/m²");
  require_positive(command.thickness, "thickness", command.unit.c_str());
  require(command.tolerance >= 0, "the tolerance ", command.tolerance,
          " is negative, or no number");
  for (const double x : command.about)
    require(std::isfinite(x), "--about: ", x, " m is not finite");
  require(!command.mass || !density.of_all,
          "there are a mass and a density: give one of them, and the other follows from it");
  require(density.of_parts.empty() || !command.thickness,
          "--thickness is for one material: give one density, without a name");
  require(!command.thickness || command.mass || density.of_all,
          "--thickness needs a --density in kg/m³, or the --mass that you have weighed");
}

/// @throws std::invalid_argument if a double can't hold the tensor about the point of --about
void require_about(const MassCommand& command, const MassAnswer& answer) {
  if (!answer.usable || command.about.empty()) return;
  require(inertia_about(answer.body, point_of(command.about)).allFinite(),
          "--about: the inertia about this point is too large for double");
}

}  // namespace

MassAnswer mass_answer(const MassCommand& command, const std::string& file) {
  const GivenDensity density = given_density(command.density);
  require_meaning(command, density);
  const ReadMesh read(file, command.unit);
  MassAnswer answer{.file = file, .findings = {}};
  if (command.is_shell())
    integrate_shell(surface_density(command, density.of_all), read.mesh, answer);
  else if (density.of_parts.empty())
    integrate(command, density.of_all.value_or(1), read, answer);
  else
    detail::require_at([&] { integrate_parts(command, density.of_parts, read, answer); }, file,
                       ": ");
  if (answer.usable && command.mass) weigh(answer, *command.mass);
  require_about(command, answer);
  return answer;
}

std::vector<std::string> mesh_files(const std::vector<std::string>& given) {
  std::vector<std::string> files;
  for (const std::string& path : given) {
    if (!std::filesystem::is_directory(path)) {
      require(path.find('=') == std::string::npos || std::filesystem::exists(path), path,
              ": there is no such file; for a density, write --density ", path);
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
