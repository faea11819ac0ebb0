// ./tumble tour: a real object, from its mesh to its mass properties to its tumbling motion.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "support/objects/objects.hpp"
#include "tour/tour.hpp"
#include "tumble/mesh/read_obj.hpp"
#include "tumble/mesh/write_obj.hpp"

namespace {

using namespace tumble;
using namespace tumble::tour;

struct Options {
  std::string mesh, object = "t_handle", out = "build/tour";
  double density = 2700;  // aluminium
  int resolution = 64;
};

std::string names_of_objects() {
  std::string names;
  for (const auto& object : objects::all())
    names += (names.empty() ? "" : ", ") + std::string(object.name);
  return names;
}

Subject load(const Options& options) {
  Subject subject{options.object, {}, options.density, {}};
  if (!options.mesh.empty()) {
    subject.name = std::filesystem::path(options.mesh).filename().string();
    subject.mesh = read_obj(options.mesh);
  } else {
    subject.mesh = objects::find(options.object).make(options.resolution);
  }
  require_body(subject.mesh);
  subject.exact = exact_tetrahedra(subject.mesh, options.density);
  return subject;
}

void introduce(const Subject& subject) {
  const MassProperties& body = subject.exact;
  const Vec3 size = bounds(subject.mesh).sizes(), moments = principal_axes(body.inertia).moments;
  std::cout << subject.name << ": a closed mesh of " << subject.mesh.face_count() << " faces and "
            << subject.mesh.vertices.size() << " vertices\n\n";
  support::Table table({"quantity", "value", "unit"});
  const auto vector = [](const Vec3& v) {
    return support::number(v.x(), 6) + "  " + support::number(v.y(), 6) + "  " +
           support::number(v.z(), 6);
  };
  table.add({"size", vector(size), "m"});
  table.add({"mass at " + support::number(subject.density) + " kg/m³",
             support::number(body.mass, 10), "kg"});
  table.add({"centre of mass", vector(body.centre), "m"});
  table.add({"principal moments", vector(moments), "kg m²"});
  std::cout << table.text();
}

void show_objects(Output& output, int resolution) {
  progress("the other objects");
  support::Table table({"object", "faces", "mass [kg] at 2700 kg/m³", "moments [kg m²]",
                        "Mirtich's error of the inertia"});
  for (const auto& object : objects::all()) {
    const PolygonMesh mesh = object.make(resolution);
    require_body(mesh);
    const MassProperties exact = exact_tetrahedra(mesh, 2700),
                         mirtich = unchecked_mirtich(mesh, 2700);
    const Vec3 moments = principal_axes(exact.inertia).moments;
    table.add(
        {object.name, std::to_string(mesh.face_count()), support::number(exact.mass, 5),
         support::number(moments[0]) + "  " + support::number(moments[1]) + "  " +
             support::number(moments[2]),
         support::error_number((mirtich.inertia - exact.inertia).norm() / exact.inertia.norm())});
    std::ostringstream obj;
    write_obj(obj, mesh);
    output.write(std::string(object.name) + ".obj", obj.str());
  }
  output.show("Other objects to throw: ./tumble tour --object NAME", table, "objects");
}

void run(const Options& options) {
  Output output(options.out);
  const Subject subject = load(options);
  introduce(subject);
  show_mass(subject, output);
  show_drift(subject, output);
  show_solvers(subject, output);
  show_motion(subject, output);
  show_objects(output, options.resolution);
  std::cout << "\nIn " << std::filesystem::absolute(output.folder()).string() << ":";
  for (const std::string& file : output.files()) std::cout << ' ' << file;
  std::cout << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("A real object, from its mesh to its mass properties to its tumbling motion.",
               "./tumble tour");
  app.add_option("--mesh", options.mesh,
                 "a closed mesh in an OBJ file, in metres, instead of an object of ours");
  app.add_option("--object", options.object, "one of: " + names_of_objects())
      ->capture_default_str();
  app.add_option("--density", options.density, "[kg/m³]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--resolution", options.resolution, "grid cells along an object's longest side")
      ->capture_default_str()
      ->check(CLI::Range(16, 400));
  app.add_option("--out", options.out, "folder for figures and tables")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::cerr << "tumble tour: " << error.what() << '\n';
    return 1;
  }
}
