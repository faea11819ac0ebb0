#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "project/library/mesh/mesh_files.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/diagnose.hpp"
#include "tumble/mesh/parse_mesh.hpp"
#include "tumble/mesh/parse_stl.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

const std::string facet_begin = "facet normal 0 0 1\nouter loop\n";
const std::string three_vertices = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
const std::string facet_end = "endloop\nendfacet\n";

std::string solid_of(const std::string& facets) { return "solid x\n" + facets + "endsolid x\n"; }

void stl_refused(const std::string& bytes, const char* what) {
  CAPTURE(bytes.substr(0, 200));
  CHECK_THROWS_WITH_AS(parse_stl(bytes, "test.stl"), doctest::Contains(what),
                       std::invalid_argument);
}

/// A file with other bytes at some place.
std::string with_bytes(std::string file, std::size_t at, const std::string& bytes) {
  return file.replace(at, bytes.size(), bytes);
}

}  // namespace

TEST_CASE("parse_stl: facets that meet share their vertices") {
  const PolygonMesh cube = test::triangulated(test::cube());
  for (const std::string& file : {test::text_stl(cube), test::binary_stl(cube)}) {
    const PolygonMesh mesh = parse_stl(file, "cube.stl");
    CHECK(mesh.face_count() == 12);
    CHECK(mesh.vertices.size() == 8);
    CHECK(diagnose(mesh).empty());
    CHECK(mesh.vertex(0) == Vec3(0, 0, 0));  // in the order of the file
    CHECK(mesh.vertex(1) == Vec3(0, 1, 0));
  }
}

TEST_CASE("parse_stl: −0 is 0, and nothing else is moved") {
  const std::string near = "vertex -0 1e-300 0\nvertex 0 -0 -0.0\nvertex 0 1 0\n";
  const PolygonMesh mesh = parse_stl(
      solid_of(facet_begin + three_vertices + facet_end + facet_begin + near + facet_end), "x");
  CHECK(mesh.vertices.size() == 4);
  CHECK(mesh.corners == std::vector<int>{0, 1, 2, 3, 0, 2});
  CHECK_FALSE(std::signbit(mesh.vertex(3).x()));
}

TEST_CASE("parse_stl: thousands of vertices are found again") {
  const PolygonMesh torus = test::triangulated(test::torus(90, 60));
  const PolygonMesh mesh = parse_stl(test::binary_stl(torus), "torus.stl");
  CHECK(mesh.face_count() == torus.face_count());
  CHECK(mesh.vertices.size() == torus.vertices.size());
  for (int f = 0; f < mesh.face_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(mesh.vertex(mesh.face(f)[k]) ==
            torus.vertex(torus.face(f)[k]).cast<float>().cast<double>());
}

TEST_CASE("parse_stl: a binary file may begin with 'solid'") {
  const PolygonMesh cube = test::triangulated(test::cube());
  CHECK(parse_stl(test::binary_stl(cube, "solid made by a program"), "x").face_count() == 12);
  stl_refused(test::binary_stl(cube, "solid").substr(0, 683),
              "test.stl, byte 80: the header announces 12 facets, which take 684 bytes, but the "
              "file has 683");
}

TEST_CASE("parse_stl: refuses a binary file that is not as long as its facets") {
  const std::string file = test::binary_stl(test::triangulated(test::cube()));
  for (const std::size_t size : {84u, 85u, 133u, 134u, 600u})
    stl_refused(file.substr(0, size), "byte 80: the header announces 12 facets");
  stl_refused(file + "x", "but the file has 685");
  stl_refused(with_bytes(file, 80, "\xFF\xFF\xFF\xFF"),
              "announces 4294967295 facets, which take 214748364834 bytes");
  stl_refused(file.substr(0, 83), "a header of 84 bytes, and this has 83 bytes");
  stl_refused("", "this has 0 bytes");
  stl_refused(with_bytes(file.substr(0, 84), 80, std::string(4, '\0')), "no faces");
}

TEST_CASE("parse_stl: refuses a vertex that is not finite, and says which") {
  const std::string file = test::binary_stl(test::triangulated(test::cube()));
  const float inf = std::numeric_limits<float>::infinity();
  stl_refused(with_bytes(file, 84 + 3 * 50 + 12 + 12, test::bytes_of(inf)),
              "test.stl, byte 258: facet #4 has the vertex (inf");
  stl_refused(solid_of(facet_begin + "vertex 0 0 nan\n"),
              "line 4: facet #1 has the coordinate 'nan'");
  stl_refused(solid_of(facet_begin + "vertex 0 1e999 0\n"), "'1e999'");
  stl_refused(solid_of(facet_begin + "vertex 0 1,5 0\n"), "'1,5'");
}

TEST_CASE("parse_stl: words are separated by anything, capitals do not matter") {
  CHECK(
      parse_stl(
          "\r\n SOLID\rFacet Normal 0 0\tnan Outer Loop Vertex 0 0 0 vertex 1 0\r\n0 vertex 0 1 0 "
          "endLoop endfacet\rEndSolid",
          "x")
          .face_count() == 1);
  const std::string one = solid_of(facet_begin + three_vertices + facet_end);
  CHECK(parse_stl("\xEF\xBB\xBF" + one + "\n\n" + one, "x").face_count() == 2);
}

TEST_CASE("parse_stl: all may stand in one line, with names or without") {
  const auto in_one_line = [](std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  };
  const std::string facet = facet_begin + three_vertices + facet_end;
  CHECK(parse_stl(in_one_line(solid_of(facet + facet)), "x").face_count() == 2);
  CHECK(parse_stl(in_one_line("solid " + facet + "endsolid"), "x").face_count() == 1);
  CHECK(parse_stl(in_one_line(solid_of(facet) + solid_of(facet)), "x").face_count() == 2);
  CHECK(
      parse_stl("solid a facet of it\n" + facet + "endsolid a solid facet\n" + solid_of(facet), "x")
          .face_count() == 2);
}

TEST_CASE("parse_stl: a name may be made of keywords") {
  const std::string facet = facet_begin + three_vertices + facet_end;
  for (const std::string name :
       {"facet normal x", "facet", "facet normal", "facet normal 0 0 1", "endsolid", "solid",
        "facet normal facet normal", "Facet Normal\tmap of it", "solid facet normal x",
        "facet normal vertex map", "a facet normal outer hull"}) {
    CAPTURE(name);
    const std::string one = "solid " + name + '\n' + facet + facet + "endsolid " + name + '\n';
    CHECK(parse_stl(one, "x").face_count() == 2);
    CHECK(parse_stl(one + one, "x").face_count() == 4);
  }
}

TEST_CASE("parse_stl: no facet is taken for a name, whatever is wrong with it") {
  for (const char* normal : {"0 0 z", "0 0", "0 0 1 0"})
    for (const char* begin : {" outer loop ", " outre loop ", " "}) {
      const std::string bad = std::string("facet normal ") + normal + begin + three_vertices;
      stl_refused(
          "solid x " + bad + facet_end + facet_begin + three_vertices + facet_end + "endsolid x",
          "facet #1");
    }
}

TEST_CASE("parse_stl: a facet that has lost its loop is not read as a name") {
  const std::string facet = facet_begin + three_vertices + facet_end;
  stl_refused("solid x facet normal 0 0 1 " + facet + "endsolid x", "facet #1");
  stl_refused("solid x facet normal 0 0 1 endfacet " + facet + "endsolid x", "facet #1");
}

TEST_CASE("parse_stl: thousands of solids in one line take no longer than in many") {
  std::string text = solid_of(facet_begin + three_vertices + facet_end);
  std::replace(text.begin(), text.end(), '\n', ' ');
  constexpr int count = 30'000;
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  CHECK(parse_stl(all, "x").face_count() == count);  // minutes, if each looks at all that follow
}

TEST_CASE("parse_stl: refuses a facet without three vertices, and words in the wrong place") {
  const std::string two = "vertex 0 0 0\nvertex 1 0 0\n";
  stl_refused(solid_of(facet_begin + two + facet_end),
              "test.stl, line 6: facet #1 has 2 vertices, and needs 3");
  stl_refused(solid_of(facet_begin + three_vertices + "vertex 1 1 0\n" + facet_end),
              "line 7: facet #1 has more than 3 vertices");
  stl_refused("solid x\n" + facet_begin + three_vertices,
              "the text ends where 'endloop' should be");
  stl_refused("solid x\n" + facet_begin + three_vertices + facet_end,
              "the text ends where 'endsolid' should be");
  stl_refused(solid_of(facet_begin + three_vertices + facet_end) + "more\n",
              "line 10: facet #2 'more' where 'solid' should be");
  stl_refused(solid_of("facet normal 0 outer loop\n"),
              "line 2: facet #1 has 'outer' where a number of its normal should be");
  stl_refused("solid x\n", "the text ends where 'endsolid' should be");
  stl_refused("# by a program\n" + std::string(99, ' ') + solid_of(""),
              "line 1: an ASCII STL file begins with 'solid', not with '#'");
  stl_refused("version https://git-lfs.github.com/spec/v1\n" + std::string(99, 'x'),
              "not with 'version': it begins like a Git LFS pointer");
  stl_refused(solid_of(""), "no faces");
}

TEST_CASE("parse_stl: bytes 0, blanks and the mark of DOS may fill up the end of a text") {
  const std::string one = solid_of(facet_begin + three_vertices + facet_end);
  for (const std::string& padding :
       {std::string(1, '\0'), std::string(600, '\0'), std::string("  \t\r\n"),
        std::string("\n\x1A"), std::string("\x1A") + std::string(127, '\0')}) {
    CHECK(parse_stl(one + padding, "x").face_count() == 1);
    CHECK(parse_mesh(one + padding, "x").face_count() == 1);
  }
  stl_refused(one + std::string(9, '\0') + one, "the header announces");
  const std::string torn = one.substr(0, one.find("endsolid"));
  for (const char* end : {"", "\x1A"})  // which leaves the lines as they were
    stl_refused(torn + end, "test.stl, line 9: the text ends where 'endsolid' should be");
}

TEST_CASE("parse_stl: what some programs write for not-a-number is passed over in normals alone") {
  for (const std::string word : {"1.#QNAN", "-1.#IND", "-nan(ind)", "nan", "1.#INF"}) {
    const std::string normal = "facet normal " + word + ' ' + word + ' ' + word + "\nouter loop\n";
    CHECK(parse_stl(solid_of(normal + three_vertices + facet_end), "x").face_count() == 1);
    stl_refused(solid_of(facet_begin + "vertex 0 " + word + " 0\n"),
                ("line 4: facet #1 has the coordinate '" + word + "'").c_str());
  }
}
