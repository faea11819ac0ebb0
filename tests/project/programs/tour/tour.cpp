// The tour from outside: what it leaves, and what it says to bad input.
#include <doctest/doctest.h>

#include <string>

#include <fstream>
#include <iterator>

#include "project/harness/command.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/scanned_meshes.hpp"

using namespace tumble::test;

namespace {

const std::filesystem::path folder = std::filesystem::temp_directory_path() / "tumble_test_tour";

CommandResult tour(const std::string& arguments) {
  std::filesystem::create_directories(folder);
  return run_command(std::string(std::getenv("TUMBLE_TOUR")) + " --out " + folder.string() + " " +
                     arguments);
}

std::string content(const std::string& file) {
  std::ifstream stream(folder / file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string mesh_file(const std::string& text) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "mesh.obj") << text;
  return (folder / "mesh.obj").string();
}

const std::string open_tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n";

void check_complete(const CommandResult& result) {
  CAPTURE(result.output);
  CHECK(result.status == 0);
  for (const char* heading :
       {"Mass properties three ways", "Drift", "Solvers", "Tumbling", "Mirtich"})
    CHECK(mentions(result.output, heading));
  for (const char* file :
       {"mass.svg", "drift.svg", "solvers.svg", "solvers_time.svg", "spin.svg", "tumbling.svg"}) {
    CAPTURE(std::string(file));
    const std::string svg = content(file);
    CHECK(mentions(svg, "<svg ", "</svg>"));
    CHECK_FALSE(mentions(svg, "nan"));
    CHECK_FALSE(mentions(svg, "inf"));
  }
  CHECK(content("mass.csv").rfind("method,mass error", 0) == 0);
  CHECK(content("motion_samples.csv").rfind("t [s],x,y", 0) == 0);
}

}  // namespace

TEST_CASE("tour: shows every topic and leaves its figures and tables") {
  std::filesystem::remove_all(folder);
  check_complete(tour("--object gear"));
}

TEST_CASE("tour: the picture on the front page is the one that it draws") {
  CHECK(tour("").status == 0);
  const std::filesystem::path root = std::getenv("TUMBLE_ROOT");
  std::ifstream kept(root / "chapters/tour/figures/tumbling.svg");
  CHECK_MESSAGE(content("tumbling.svg") == std::string(std::istreambuf_iterator<char>(kept), {}),
                "./tumble book --write updates the page");
}

TEST_CASE("tour: takes a user's mesh") {
  check_complete(tour("--mesh " + mesh_file(open_tetrahedron + "f 1 4 3\n")));
}

TEST_CASE("tour: says that it has welded a mesh") {
  const std::string last = "v 0 0 0\nv 0 0 1\nv 0 1 0\nf 5 6 7\n";
  const CommandResult result = tour("--mesh " + mesh_file(open_tetrahedron + last));
  CHECK(result.status == 0);
  CHECK(mentions(result.output, "welded: we take 3 vertices"));
}

TEST_CASE("tour: refuses a mesh that does not bound a body, naming file and edge") {
  const CommandResult result = tour("--mesh " + mesh_file(open_tetrahedron));
  CAPTURE(result.output);
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "mesh.obj", "open_edge", "#1", "#3"));
}

TEST_CASE("tour: says what is wrong with a file or an option") {
  CommandResult result = tour("--mesh no/such/file.obj");
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "no/such/file.obj"));
  result = tour("--mesh " + mesh_file("v 0 0 0\nf 1 2 3\n"));
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "line 2", "face #1"));
  result = tour("--density -1");
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "density"));
  result = tour("--object teapot");
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "teapot", "t_handle"));
  result = run_command(std::string(std::getenv("TUMBLE_TOUR")) + " --out /dev/null/tour");
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "/dev/null/tour"));
}

TEST_CASE("tour: a scanned cow") {
  if (!have_scanned_meshes()) return;
  check_complete(tour("--mesh " + scanned_mesh("spot.obj")));
}
