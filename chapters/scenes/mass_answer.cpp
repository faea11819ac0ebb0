#include "scenes/mass_answer.hpp"

#include <cmath>

#include "scenes/given_density.hpp"
#include "scenes/length_unit.hpp"
#include "scenes/mass_output.hpp"
#include "scenes/mesh_in_unit.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/mass/parts/diagnose.hpp"
#include "tumble/mass/require_volume.hpp"
#include "tumble/mass/shell.hpp"
#include "tumble/mesh/check_edges.hpp"
#include "tumble/mesh/weld.hpp"

namespace tumble::scenes {
namespace {

Accuracy accuracy_of(const std::string& name) {
  if (name == "fast") return Accuracy::fast;
  return name == "textbook" ? Accuracy::textbook : Accuracy::tight;
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
  return density.value_or(1) * length_unit(command.unit).in_metres(*command.thickness);
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

/// The surface may be open, but what is there twice, as in files for drawing, has its mass twice.
void integrate_shell(const MassCommand& command, double surface_density, const ReadMesh& read,
                     MassAnswer& answer) {
  answer.density = surface_density;
  MassProperties& shell = answer.body;
  shell = shells::mass_properties(read.written, surface_density);
  convert_to_metres(shell, read.unit, 2);
  detail::require_normal(shell, "shell");
  note(command, detail::find_duplicate_faces(weld(read.written)), answer);
  answer.area = double(read.unit.in_metres(shells::area(read.written), 2));
}

void integrate(const MassCommand& command, double density, const ReadMesh& read,
               MassAnswer& answer) {
  const auto diagnosed = [&](std::optional<double> rounding) {
    return diagnose(read.in_metres(), {}, search_of(command), rounding);
  };
  note(command, findings_of(read, diagnosed), answer);
  if (!answer.usable) return;
  answer.density = density;
  answer.body = unchecked_mass_properties(read.written, density, accuracy_of(command.accuracy));
  convert_to_metres(answer.body, read.unit);
  if (!command.accept) require_volume(answer.body);
  answer.volume = answer.body.mass / density;
  answer.volume_bound = answer.body.mass_error_bound + detail::unit_roundoff;
}

void integrate_parts(const MassCommand& command, const parts::Densities& densities,
                     const ReadMesh& read, MassAnswer& answer) {
  const auto diagnosed = [&](std::optional<double> rounding) {
    return parts::diagnose(parts::split(read.in_metres(), densities), {}, search_of(command),
                           rounding);
  };
  note(command, findings_of(read, diagnosed), answer);
  if (!answer.usable) return;
  const std::vector<parts::Part> all = parts::split(read.written, densities);
  parts::Assembly body = parts::unchecked_mass_properties(all, accuracy_of(command.accuracy));
  convert_to_metres(body, read.unit);
  for (parts::PartMass& part : body.parts) convert_to_metres(part, read.unit);
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

void integrate_as_asked(const MassCommand& command, const ReadMesh& read, MassAnswer& answer) {
  const GivenDensity density = given_density(command.density);
  if (command.is_shell())
    integrate_shell(command, surface_density(command, density.of_all), read, answer);
  else if (density.of_parts.empty())
    integrate(command, density.of_all.value_or(1), read, answer);
  else
    integrate_parts(command, density.of_parts, read, answer);
}

/// @throws std::invalid_argument if a double can't hold the tensor about the point of --about
void require_about(const MassCommand& command, const MassAnswer& answer) {
  if (!answer.usable || command.about.empty()) return;
  require(inertia_about(answer.body, point_of(command.about)).allFinite(),
          "--about: the inertia about this point is too large for double");
}

}  // namespace

void require_meaning(const MassCommand& command) {
  const GivenDensity density = given_density(command.density);
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
  require(
      !command.mass || !command.shell,
      "there are a mass and a surface density, --shell: give one of them, and the other follows "
      "from it. For a shell of this mass say --thickness in place of --shell");
  require(density.of_parts.empty() || !command.thickness,
          "--thickness is for one material: give one density, without a name");
  require(!command.thickness || command.mass || density.of_all,
          "--thickness needs a --density in kg/m³, or the --mass that you have weighed");
}

MassAnswer mass_answer(const MassCommand& command, const std::string& file) {
  const ReadMesh read(file, command.unit, !command.is_shell());
  MassAnswer answer{.file = file, .findings = {}, .welded = read.welded};
  detail::require_at(
      [&] {
        integrate_as_asked(command, read, answer);
        if (answer.usable && command.mass) weigh(answer, *command.mass);
        require_about(command, answer);
      },
      file, ": ");
  return answer;
}

MassAnswer answer_or_refusal(const MassCommand& command, const std::string& file) {
  try {
    return mass_answer(command, file);
  } catch (const std::exception& problem) {
    return {.file = file, .findings = {}, .refusal = problem.what(), .usable = false};
  }
}

}  // namespace tumble::scenes
