// ./tumble tour: a real object, from its mesh to its mass properties to its tumbling motion.
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "objects/objects.hpp"
#include "support/command_line.hpp"
#include "support/mesh_notes.hpp"
#include "support/terminal.hpp"
#include "support/view.hpp"
#include "tour/tour.hpp"
#include "tumble/mesh/read_mesh.hpp"
#include "tumble/mesh/weld_if_open.hpp"
#include "tumble/mesh/write_obj.hpp"

namespace {

using namespace tumble;
using namespace tumble::tour;

struct Options {
  std::string mesh, object = objects::all.front().name, out = "build/tour";
  std::optional<double> density;
};

std::string names_of_objects() {
  std::string names;
  for (const objects::Object& object : objects::all)
    names += (names.empty() ? "" : ", ") + std::string(object.name);
  return names;
}

const objects::Object& find_object(const std::string& name) {
  for (const objects::Object& object : objects::all)
    if (object.name == name) return object;
  throw std::invalid_argument("there is no object '" + name + "'; there are " + names_of_objects());
}

/// @throws std::invalid_argument naming the subject if the mesh does not bound a body
Subject make_subject(const std::string& name, const PolygonMesh& mesh, const PolygonMesh& drawing,
                     double density, int welded = 0) {
  const std::vector<MeshDefect> findings = diagnose(mesh);
  detail::require_at([&] { require_body(findings); }, name, ": ");
  return {name,
          mesh,
          drawing,
          density,
          unchecked_mass_properties(mesh, density),
          support::mesh_notes(welded, findings)};
}

Subject load(const Options& options) {
  if (options.mesh.empty()) {
    const objects::Object& object = find_object(options.object);
    return make_subject(object.name, object.mesh(object.fine), object.mesh(object.for_drawings),
                        options.density.value_or(object.density));
  }
  constexpr double water = 1000;
  PolygonMesh mesh = read_mesh(options.mesh);
  const int welded = detail::weld_if_open(mesh);
  return make_subject(std::filesystem::path(options.mesh).filename().string(), mesh,
                      support::coarsened(mesh, 22), options.density.value_or(water), welded);
}

std::string three_numbers(const Vec3& v, int digits) {
  return support::number(v.x(), digits) + "  " + support::number(v.y(), digits) + "  " +
         support::number(v.z(), digits);
}

void introduce(const Subject& subject) {
  const MassProperties& body = subject.exact;
  const Vec3 size = bounds(subject.mesh).sizes(), moments = principal_axes(body.inertia).moments;
  std::cout << subject.name << ": a closed mesh of " << subject.mesh.face_count() << " faces and "
            << subject.mesh.vertices.size() << " vertices\n\n";
  for (const std::string& note : subject.notes) std::cout << support::fitted(note) << "\n\n";
  support::Table table({"quantity", "value", "unit"});
  table.add({"size", three_numbers(size, 6), "m"});
  table.add({"mass at " + support::number(subject.density, 6) + " kg/m³",
             support::number(body.mass, 10), "kg"});
  table.add({"centre of mass", three_numbers(body.centre, 6), "m"});
  table.add({"principal moments", three_numbers(moments, 6), "kg m²"});
  std::cout << support::fitted(table);
}

void show_objects(Output& output) {
  progress("the other objects");
  support::Table table({"object", "faces", "density [kg/m³]", "mass [kg]", "moments [kg m²]",
                        "Mirtich's error of the inertia"});
  for (const objects::Object& object : objects::all) {
    const Subject subject = make_subject(object.name, object.mesh(object.fine), {}, object.density);
    const Mat3& I = subject.exact.inertia;
    const Vec3 moments = principal_axes(I).moments;
    const Mat3 found = detail::unchecked_mirtich(subject.mesh, subject.density).inertia;
    table.add({subject.name, std::to_string(subject.mesh.face_count()),
               support::number(subject.density, 6), support::number(subject.exact.mass, 5),
               three_numbers(moments, 3), support::error_number((found - I).norm() / I.norm())});
    std::ostringstream obj;
    write_obj(obj, subject.mesh);
    output.write(subject.name + ".obj", obj.str());
  }
  output.show("Other objects that you can throw: ./tumble tour --object NAME", table, "objects");
}

void run(const Options& options) {
  const Subject subject = load(options);
  Output output(options.out);
  introduce(subject);
  show_mass(subject, output);
  show_drift(subject, output);
  show_solvers(subject, output);
  show_motion(subject, output);
  show_objects(output);
  std::cout << "\nYou find the figures, tables and meshes in "
            << std::filesystem::absolute(output.folder()).lexically_normal().string() << ":\n";
  for (const char* kind : {".svg", ".csv", ".obj"}) {
    std::cout << "  ";
    for (const std::string& file : output.files())
      if (file.ends_with(kind)) std::cout << ' ' << file;
    std::cout << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("A real object, from its mesh to its mass properties to its tumbling motion.",
               "./tumble tour");
  app.add_option(
      "--mesh", options.mesh,
      "your closed mesh, an OBJ, STL or PLY file in metres, instead of one of our objects");
  app.add_option("--object", options.object, "one of: " + names_of_objects())
      ->capture_default_str();
  app.add_option("--density", options.density, "[kg/m³]; for your mesh it is 1000 if you don't say")
      ->check(CLI::PositiveNumber);
  app.add_option("--out", options.out, "the folder that we write figures and tables into")
      ->capture_default_str();
  return support::run_command_line(app, argc, argv, [&] {
    run(options);
    return support::exit_status::achieved;
  });
}
