#include <doctest/doctest.h>

#include <cmath>

#include "project/library/mesh/mesh_files.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/parse_ply.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

const std::string ply_vertices =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string ply_faces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string four_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

std::string ascii_ply(const std::string& elements, const std::string& body) {
  return "ply\nformat ascii 1.0\ncomment any text\n" + elements + "end_header\n" + body;
}

void ply_refused(const std::string& bytes, const char* what) {
  CAPTURE(bytes.substr(0, 400));
  CHECK_THROWS_WITH_AS(parse_ply(bytes, "test.ply"), doctest::Contains(what),
                       std::invalid_argument);
}

void header_refused(const std::string& line, const char* what) {
  ply_refused(ascii_ply(line + "\n" + ply_vertices + ply_faces, four_points + "3 0 1 2\n"), what);
}

}  // namespace

TEST_CASE("parse_ply: the same mesh in every format") {
  const PolygonMesh cube = test::cube();
  for (const std::string& file :
       {test::text_ply(cube), test::binary_ply(cube), test::binary_ply(cube, false)}) {
    const PolygonMesh mesh = parse_ply(file, "cube.ply");
    CHECK(mesh.vertices == cube.vertices);
    CHECK(mesh.corners == cube.corners);
    CHECK(mesh.first_corner == cube.first_corner);
  }
}

TEST_CASE("parse_ply: properties of any type in any order, and elements that mean nothing") {
  for (const bool little : {true, false}) {
    const auto b = [&](auto value) { return test::bytes_of(value, little); };
    const std::string header =
        std::string("ply\nformat ") + (little ? "binary_little_endian" : "binary_big_endian") +
        " 1.0\nobj_info x\nelement material 2\nproperty list ushort double a\nproperty char b\n"
        "element face 1\nproperty uint8 flag\nproperty list int16 uint16 vertex_index\n"
        "property float64 area\nelement vertex 3\nproperty int8 z\nproperty uint32 y\n"
        "property list uint8 float32 weights\nproperty int16 x\nend_header\n";
    const std::string materials =
        b(std::uint16_t{1}) + b(2.5) + "\x07" + b(std::uint16_t{0}) + "\x08";
    const std::string face = "\x01" + b(std::uint16_t{3}) + b(std::uint16_t{2}) +
                             b(std::uint16_t{0}) + b(std::uint16_t{1}) + b(0.5);
    const auto vertex = [&](const char* z, std::uint32_t y, std::uint16_t x) {
      return z + b(y) + "\x01" + b(1.0F) + b(x);
    };
    const std::string vertices =
        vertex("\xFE", 4'000'000'000u, 65535) + vertex("\x01", 5, 6) + vertex("\x02", 7, 8);
    const PolygonMesh mesh = parse_ply(header + materials + face + vertices, "x");
    CHECK(mesh.corners == std::vector<int>{2, 0, 1});
    CHECK(mesh.vertex(0) == Vec3(-1, 4e9, -2));
    CHECK(mesh.vertex(2) == Vec3(8, 7, 2));
  }
}

TEST_CASE("parse_ply: lines may end in any way, numbers are correctly rounded") {
  const std::string text =
      ascii_ply(ply_vertices + ply_faces, "\n0.1 0 0\n\n 1\t0 0 \n0 1e0 0\n0 0 1\n4 0 1 2 3");
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string file;
    for (const char c : text) file += c == '\n' ? end : std::string(1, c);
    const PolygonMesh mesh = parse_ply(file, "x");
    CHECK(mesh.corners == std::vector<int>{0, 1, 2, 3});
    CHECK(mesh.vertex(0).x() == 0.1);
  }
}

TEST_CASE("parse_ply: comments and empty lines may stand anywhere in the header") {
  const std::string file = "ply\ncomment by a program\n\nobj_info x\nformat ascii 1.0\n \n" +
                           ply_vertices + "\ncomment\n" + ply_faces + "\t\nend_header\n" +
                           four_points + "3 0 1 2\n";
  CHECK(parse_ply(file, "x").corners == std::vector<int>{0, 1, 2});
}

TEST_CASE("parse_ply: lengths and numbers of vertices that are floats are read if they are whole") {
  const auto with = [](const std::string& types, const std::string& face) {
    return ascii_ply(ply_vertices + "element face 1\nproperty list " + types + " vertex_indices\n",
                     four_points + face);
  };
  for (const char* types : {"float int", "uchar float", "double double"})
    CHECK(parse_ply(with(types, "3 2 1.0 3\n"), "x").corners == std::vector<int>{2, 1, 3});
  ply_refused(with("float int", "3.5 0 1 2\n"),
              "line 15: face #1 has 3.5 for 'vertex_indices', which is not a whole number");
  ply_refused(with("uchar float", "3 0 1 1.5\n"), "has 1.5 for 'vertex_indices'");
  ply_refused(with("uchar float", "3 0 1 16777217\n"), "a whole number that float holds for sure");
  for (const bool little : {true, false}) {
    const auto b = [&](float value) { return test::bytes_of(value, little); };
    const std::string header = std::string("ply\nformat ") +
                               (little ? "binary_little_endian" : "binary_big_endian") + " 1.0\n" +
                               ply_vertices +
                               "element face 1\nproperty list float float vertex_index\n"
                               "end_header\n";
    std::string body;
    for (int i = 0; i < 12; ++i) body += b(static_cast<float>(i));
    CHECK(parse_ply(header + body + b(3) + b(3) + b(0) + b(2), "x").corners ==
          std::vector<int>{3, 0, 2});
    ply_refused(header + body + b(3) + b(std::nanf("")) + b(0) + b(2), "face #1 has nan");
  }
}

TEST_CASE("parse_ply: a number that looks like a line end is one") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string file;
    for (const char c : test::ply_header(test::triangulated(test::cube()), "binary_little_endian"))
      file += c == '\n' ? end : std::string(1, c);
    std::string body;
    const PolygonMesh cube = test::triangulated(test::cube());
    for (const Vec3& p : cube.vertices)
      for (int k = 0; k < 3; ++k) body += "\n" + test::bytes_of(p[k]).substr(1);
    for (int f = 0; f < 12; ++f) {
      body += "\x03";
      for (const int v : cube.face(f)) body += test::bytes_of(static_cast<std::uint32_t>(v));
    }
    CHECK(parse_ply(file + body, "x").vertices.size() == 8);
  }
}

TEST_CASE("parse_ply: refuses a header, and says which line and word") {
  ply_refused("plx\n", "test.ply, line 1: 'plx' where 'ply' should be");
  ply_refused("ply\nelement vertex 4\n", "line 2: 'element' where 'format …' should be");
  ply_refused("ply\nend_header\n", "line 2: 'end_header' where 'format …' should be");
  ply_refused("ply\nformat binary_middle_endian 1.0\n", "'binary_middle_endian' is not a format");
  ply_refused("ply\nformat ascii 2.0\n", "'2.0' where '1.0' should be");
  ply_refused("ply\nformat ascii 1.0\nelement vertex 4\n",
              "line 4: the text ends where 'end_header'");
  header_refused("elephant 4", "line 4: 'elephant' is not a keyword");
  header_refused("format ascii 1.0", "line 4: 'format' where the elements should be");
  header_refused("element x -1", "line 4: '-1' is not a number of elements");
  header_refused("element x 1e3", "'1e3'");
  header_refused("element x", "'' is not a number of elements");
  header_refused("element vertex 3", "line 5: a second element 'vertex'");
  header_refused("property float x", "a property before the first element");
  header_refused("element e 1\nproperty long x", "line 5: 'long' is not a type");
  header_refused("element e 1\nproperty float", "a property without a name");
  header_refused("element e 1\nproperty float x y", "'y' where the line should end");
  header_refused("element e 1\nproperty float x\nproperty float x", "a second property 'x'");
  header_refused("element e 1", "the element 'e' has no properties");
}

TEST_CASE("parse_ply: refuses elements that no mesh is made of") {
  const std::string plane = "element vertex 4\nproperty float x\nproperty float y\n";
  ply_refused(ascii_ply(plane + ply_faces, four_points), "a vertex has no coordinate 'z'");
  const std::string faces = "element face 1\nproperty int vertex_indices\n";
  ply_refused(ascii_ply(ply_vertices + faces, four_points + "3\n"),
              "a face has no list 'vertex_indices'");
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  ply_refused(ascii_ply(ply_vertices + strips, four_points + "4 0 1 2 3\n"),
              "part of the surface is in strips of triangles ('tristrips'), which are not read");
  ply_refused(ascii_ply(ply_vertices, four_points), "no faces (4 vertices)");
  const auto renamed = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string mesh = ascii_ply(ply_vertices + ply_faces, four_points + "3 0 1 2\n");
  ply_refused(renamed(mesh, "element vertex", "element Vertex"),
              "no element 'vertex' among 'Vertex', 'face'");
  ply_refused(renamed(mesh, "element face", "element faces"),
              "no faces (4 vertices): no element 'face' among 'vertex', 'faces'");
  ply_refused("ply\nformat ascii 1.0\nend_header\n", "no element 'vertex' among none");
}

TEST_CASE("parse_ply: refuses values, and says which element and where") {
  const auto body_refused = [](const std::string& body, const char* what) {
    ply_refused(ascii_ply(ply_vertices + ply_faces, body), what);
  };
  body_refused("0 0 0\n1 0\n0 1 0\n0 0 1\n3 0 1 2\n", "line 12: vertex #2 has no value for 'z'");
  body_refused("0 0 0\n1 0 0 0\n0 1 0\n0 0 1\n3 0 1 2\n", "vertex #2 has '0' after its last value");
  body_refused("0 0 0\n1 0 nan\n0 1 0\n0 0 1\n3 0 1 2\n", "vertex #2 has 'nan' for 'z'");
  body_refused("0 0 0\n1 0 1e999\n0 1 0\n0 0 1\n3 0 1 2\n", "'1e999'");
  body_refused(four_points + "2 0 1\n", "line 15: face #1 has 2 corners, and needs 3");
  body_refused(four_points + "3 0 1 4\n", "face #1 has vertex 4, but there are 4 vertices, from 0");
  body_refused(four_points + "3 0 1 -1\n", "face #1 has vertex -1");
  body_refused(four_points + "3 0 1 1.5\n",
               "'1.5' for 'vertex_indices', which is not of the type int");
  body_refused(four_points + "300 0 1 2\n",
               "'300' for 'vertex_indices', which is not of the type uchar");
  body_refused(four_points + "4 0 1 2\n", "face #1 has no value for 'vertex_indices'");
  body_refused(four_points + "3 0 1 2\n3 0 1 2\n", "line 16: '3' after the last element");
  body_refused(four_points, "face #1 has no value for 'vertex_indices'");
}

TEST_CASE("parse_ply: bytes 0 may fill up the end of a text") {
  const std::string file = ascii_ply(ply_vertices + ply_faces, four_points + "3 0 1 2\n");
  CHECK(parse_ply(file + std::string(99, '\0'), "x").face_count() == 1);
  ply_refused(file + std::string("\0 1", 3), "'\\x00' after the last element");
}

TEST_CASE("parse_ply: counts that lie take no memory") {
  const std::string many = "element vertex 1000000000000000000\nproperty float x\n";
  ply_refused(ascii_ply(many, "0\n"),
              "announces 1000000000000000000 elements 'vertex', but only 2 bytes");
  ply_refused(ascii_ply("element vertex " + std::string(50, '9') + "\nproperty float x\n", "0\n"),
              "but only 2 bytes");
  std::string file = test::binary_ply(test::cube());
  file.replace(file.find("vertex 8"), 8, "vertex 9");
  ply_refused(file, "face #1 has 0 corners");  // where the ninth vertex took its bytes
  file.replace(file.find("vertex 9"), 8, "vertex 2000000000");
  ply_refused(file, "the header announces 2000000000 elements 'vertex', but only 294 bytes follow");
}

TEST_CASE("parse_ply: refuses a binary file that is shorter or longer than its elements") {
  const std::string file = test::binary_ply(test::cube());
  for (std::size_t size = 0; size < file.size(); ++size)
    CHECK_THROWS_AS(parse_ply(file.substr(0, size), "x"), std::invalid_argument);
  ply_refused(file.substr(0, file.size() - 1),
              "face #6 has 1 values for 'vertex_indices', but the file ends after 3 bytes");
  ply_refused(file + "\n", "1 bytes are left after the last element");
  const std::size_t begin = file.find("end_header\n") + 11;
  std::string spoilt = file;
  spoilt.replace(begin + 24, 8, test::bytes_of(std::nan("")));
  ply_refused(spoilt, ("byte " + std::to_string(begin + 24) +
                       ": vertex #2 has nan for 'x', which is not a finite number")
                          .c_str());
  spoilt = file;
  spoilt[begin + 8 * 24] = '\x02';
  ply_refused(spoilt, "face #1 has 2 corners, and needs 3");
}
