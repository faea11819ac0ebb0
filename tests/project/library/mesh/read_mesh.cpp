#include "tumble/mesh/read_mesh.hpp"

#include <doctest/doctest.h>

#include <filesystem>

#include "project/harness/scanned_meshes.hpp"
#include "project/harness/temporary_folder.hpp"
#include "project/library/mesh/mesh_files.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/parse_mesh.hpp"
#include "tumble/mesh/read_obj.hpp"
#include "tumble/mesh/weld.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

struct NamedFile {
  const char* name;
  std::string bytes;
};

std::vector<NamedFile> in_every_format(const PolygonMesh& mesh) {
  return {{"plain.obj", test::plain_obj(mesh)},
          {"full.obj", test::full_obj(mesh)},
          {"named.obj", test::named_obj(mesh)},
          {"text.stl", test::text_stl(mesh)},
          {"binary.stl", test::binary_stl(mesh, "solid")},
          {"text.ply", test::text_ply(mesh)},
          {"little.ply", test::binary_ply(mesh)},
          {"big.ply", test::binary_ply(mesh, false)}};
}

std::string stored(const test::TemporaryFolder& folder, const std::string& name,
                   const std::string& bytes) {
  const std::string path = (folder.path() / name).string();
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

void mesh_refused(const std::string& bytes, const std::string& name, const char* what) {
  CHECK_THROWS_WITH_AS(parse_mesh(bytes, name), doctest::Contains(what), std::invalid_argument);
}

}  // namespace

TEST_CASE("read_mesh: knows each format by its content, whatever the name") {
  const test::TemporaryFolder folder;
  const PolygonMesh cube = test::triangulated(test::cube());
  for (const NamedFile& file : in_every_format(cube))
    for (const std::string name : {file.name, "no_ending", "wrong.stl", "wrong.PLY", "wrong.obj"}) {
      CAPTURE(file.name);
      CAPTURE(name);
      if (std::string(file.name).ends_with(".obj") && !name.ends_with(".obj") &&
          name != "no_ending")
        continue;  // of a text the name is believed
      CHECK(parse_mesh(file.bytes, name).face_count() == 12);
      CHECK(read_mesh(stored(folder, name, file.bytes)).vertices.size() == 8);
    }
}

TEST_CASE("read_mesh: where the content says nothing, the name does") {
  mesh_refused("hello", "x.STL",
               "x.STL, line 1: an ASCII STL file begins with 'solid', not with 'hello'");
  mesh_refused(std::string("hel\0lo", 6), "x.STL",
               "x.STL: a binary STL file has a header of 84 bytes");
  mesh_refused("hello", "x.ply", "x.ply, line 1: 'hello' where 'ply' should be");
  mesh_refused("hello", "x", "x, line 1: 'hello' is not a keyword of OBJ");
  mesh_refused("", "x", "x: no faces (0 vertices)");
  mesh_refused("glTF\x02", "x.glb", "it begins like glTF");
  CHECK_THROWS_WITH_AS(read_mesh("/no/such/file"),
                       "/no/such/file: cannot be read (No such file or directory)",
                       std::runtime_error);
  CHECK_THROWS_AS(read_mesh("/"), std::runtime_error);
}

TEST_CASE("read_stl, read_ply, read_obj: read their format from a file") {
  const test::TemporaryFolder folder;
  const PolygonMesh cube = test::triangulated(test::cube());
  CHECK(read_stl(stored(folder, "a", test::binary_stl(cube))).face_count() == 12);
  CHECK(read_ply(stored(folder, "b", test::text_ply(cube))).face_count() == 12);
  CHECK(read_obj(stored(folder, "c", test::plain_obj(cube))).face_count() == 12);
  CHECK_THROWS_AS(read_stl("/no/such/file"), std::runtime_error);
  CHECK_THROWS_AS(read_ply("/"), std::runtime_error);
}

TEST_CASE("read_mesh: a file longer than a block of lines") {
  const test::TemporaryFolder folder;
  const PolygonMesh torus = test::triangulated(test::torus(120, 80));
  for (const NamedFile& file : in_every_format(torus)) {
    CAPTURE(file.name);
    REQUIRE(file.bytes.size() > 1 << 18);
    const PolygonMesh mesh = read_mesh(stored(folder, file.name, file.bytes));
    CHECK(mesh.face_count() == torus.face_count());
    CHECK(mesh.vertices.size() == torus.vertices.size());
  }
}

TEST_CASE("read_mesh: a scan is the same mesh in every format") {
  if (!test::have_scanned_meshes()) return;
  const PolygonMesh spot = test::triangulated(read_mesh(test::scanned_mesh("spot.obj")));
  const PolygonMesh ply = parse_ply(test::binary_ply(spot), "spot.ply");
  CHECK(ply.vertices == spot.vertices);
  CHECK(ply.corners == spot.corners);
  PolygonMesh rounded = spot;
  for (Vec3& p : rounded.vertices) p = p.cast<float>().cast<double>();
  const PolygonMesh stl = parse_stl(test::binary_stl(spot), "spot.stl");
  REQUIRE(stl.corners.size() == spot.corners.size());
  for (std::size_t i = 0; i < stl.corners.size(); ++i)
    CHECK(stl.vertex(stl.corners[i]) == rounded.vertex(spot.corners[i]));
  CHECK(stl.vertices.size() == weld(rounded).vertices.size());
}
