#include "tumble/mesh/read_obj.hpp"
#include "tumble/mesh/line_blocks.hpp"
#include "tumble/mesh/obj_keywords.hpp"
#include "tumble/mesh/parse_obj.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <optional>

#include "project/harness/inputs.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/write_obj.hpp"

using namespace tumble;

namespace {

PolygonMesh read(const std::string& text) {
  std::istringstream stream(text);
  return detail::read_obj(stream, "test.obj");
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

void check_refused(const std::string& text, const char* what) {
  CAPTURE(text.substr(0, 200));
  CHECK_THROWS_WITH_AS(read(text), doctest::Contains(what), std::invalid_argument);
}

}  // namespace

TEST_CASE("read_obj: polygons stay polygons, vertices stay as they are") {
  const PolygonMesh mesh = read(square + "v 9 9 9\nv 0 0 0\nf 1 2 3 4\nf 6 2 3\n");
  CHECK(mesh.vertices.size() == 6);
  CHECK(mesh.corners == std::vector<int>{0, 1, 2, 3, 5, 1, 2});
  CHECK(mesh.first_corner == std::vector<int>{0, 4, 7});
}

TEST_CASE("read_obj: texture, normals, colours, names, comments and materials are passed over") {
  const PolygonMesh mesh = read(
      "# a comment\nmtllib nowhere.mtl\no thing\ng group\ns off\nvt 0 0\nvn 0 0 1\n"
      "v 0 0 0 1 0.5 0.25\nv 1 0 0 # a corner\n  v\t1 1 0\nv +1.5 -.25 2.e-1\nusemtl none\n"
      "f 1/1/1 2//1 3/1   4 # and a face\np 1\nl 1 2\n");
  CHECK(mesh.corners == std::vector<int>{0, 1, 2, 3});
  CHECK(mesh.vertex(3) == Vec3(1.5, -0.25, 0.2));
}

TEST_CASE("read_obj: negative indices count back from the last vertex so far") {
  CHECK(read(square + "f -4 -3 -2\nv 5 5 5\nf -1 -2 1\n").corners ==
        std::vector<int>{0, 1, 2, 4, 3, 0});
}

TEST_CASE("read_obj: lines may end in any way, the last one in none") {
  for (const std::string end : {"\n", "\r\n", "\r", "\n\n\r\n"}) {
    const PolygonMesh mesh = read("v 0 0 0" + end + "v 1 0 0" + end + "v 0 1 0" + end + "f 1 2 3");
    CHECK(mesh.corners == std::vector<int>{0, 1, 2});
    CHECK(mesh.vertex(1) == Vec3(1, 0, 0));
  }
  CHECK(read("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").vertices.size() == 3);
}

TEST_CASE("read_obj: refuses a face, and says which one, where, and why") {
  check_refused(square + "f 1 2 3\nf 1 2\n", "test.obj, line 6: face #2 has 2 corners");
  check_refused(square + "f 1 2 99\n",
                "line 5: face #1 has vertex 99, but there are 4 vertices so far");
  check_refused(square + "f 1 2 5\nv 0 0 1\n", "face #1 has vertex 5");
  check_refused(square + "f 1 0 3\n", "face #1 has vertex 0");
  check_refused(square + "f 1 2 -5\n", "face #1 has vertex -5");
  check_refused(square + "f a b c\n", "face #1 has the vertex 'a', which is not an index");
  check_refused(square + "f 1 2x 3\n", "'2x'");
  check_refused(square + "f 1 2.5 3\n", "'2.5'");
  check_refused(square + "f 1 2 4294967299\n", "'4294967299'");
  check_refused(square + "f 1/2/3/4 2 3\n", "not an index");
  check_refused(square + std::string("f 1 2 3 \0\n", 11), "not an index");
}

TEST_CASE("read_obj: refuses a vertex that is not three finite numbers") {
  check_refused("v 0 0 0\nv nan 0 0\n",
                "line 2: the coordinate 'nan' of vertex #2 is not a finite number");
  check_refused("v 0 inf 0\n", "'inf'");
  check_refused("v 0 0 -1e999\n", "'-1e999'");
  check_refused("v 1 2\n", "line 1: a vertex has 3 coordinates, not 2");
  check_refused("v 1 2 # 3\n", "not 2");
  check_refused("v 1,5 2 3\n", "'1,5'");
  check_refused("v 0x10 2 3\n", "'0x10'");
  check_refused("v 1 2 3e\n", "'3e'");
  check_refused("v --1 2 3\n", "'--1'");
  check_refused("v +-1 2 3\n", "'+-1'");
}

TEST_CASE("read_obj: shows what is refused, and says what may help") {
  check_refused(square + "f 1 2 \\ 3\n", "the vertex '\\', which is not an index");
  check_refused("v 0 0 0 foo\n",
                "line 1: 'foo' behind the coordinates of vertex #1 is not a number");
  check_refused(square + "f 1/a 2 3\n", "the vertex '1/a'");
  check_refused(square + std::string("f 1 2 \0 3\n", 11),
                "the vertex '\\x00', which is not an index");
  check_refused(square + std::string("f 1 2 3/\0\n", 11), "which is not an index");
  check_refused("f 1 2 3\n" + square, "face #1 has vertex 1, but there are 0 vertices so far");
  check_refused(square + "f 1 2 3\nf 4 3 2/1/1/1\n", "face #2 has the vertex '2/1/1/1'");
  check_refused(square + "f # 1 2 3\n", "face #1 has 0 corners");
  for (const char* nothing : {"v \n", "v\n", "v"})
    check_refused(nothing, "a vertex has 3 coordinates, not 0");
  check_refused("v 1 2 #3\n", "a vertex has 3 coordinates, not 2");
  check_refused("solid x\n", "line 1: 'solid' is not a keyword of OBJ: it begins like STL");
  check_refused("\x1F\x8B\x08", "gzip");
}

TEST_CASE(
    "read_obj: what brings in surfaces from elsewhere is refused, and names like it are not") {
  const std::string body = square + "f 1 2 3 4\n";
  check_refused(body + "call handle.obj\n", "line 6: 'call' brings in another file");
  check_refused("  csh cat handle.obj\n" + body, "line 1: 'csh'");
  check_refused(body + "surf 0 1 0 1 1 2 3 4\n", "'surf' is a curved surface");
  check_refused(square + "fo 1 2 3\n", "'fo' is an old name of 'f'");
  for (const char* line : {"cstype bezier", "s off", "s 1", "c_interp on", "usemtl call", "g surf",
                           "# call handle.obj", "bevel on", "o fo", "f"})
    CHECK_MESSAGE(read(body + line + "\n").face_count() == 1, line);
}

TEST_CASE("read_obj: a line is counted once, however it ends") {
  const std::string bad = "v 1\n";
  check_refused("\n\r\n\r# x\n\n" + bad, "line 6:");
  check_refused("\r\r\n\n\r" + bad, "line 5:");
}

TEST_CASE("read_obj: further numbers are passed over, a lone f is nothing") {
  const PolygonMesh mesh = read(square + "v 1 2 3 0.5 0.5 1e9\nf\nf \nf 1/-1 2/9999999999/ 5//\n");
  CHECK(mesh.vertices.size() == 5);
  CHECK(mesh.corners == std::vector<int>{0, 1, 4});
  CHECK(read(square + "f 001 +2 -0002").corners == std::vector<int>{0, 1, 2});
}

TEST_CASE("read_obj: blocks of a few bytes are the whole") {
  const std::string text =
      "\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0\rv 0 1 0\n\n# a long comment, longer than a block\r\n"
      "f 1 2 3\r\nv 1 2\r\n";
  for (std::size_t size = 1; size < 120; ++size) {
    CAPTURE(size);
    std::istringstream stream(text);
    std::optional<detail::ObjReader> reader;
    std::string joined;
    const auto visit = [&](std::string_view block) {
      joined += block;
      if (reader)
        reader->read(block);
      else
        reader.emplace(block, "blocks");
    };
    CHECK_THROWS_WITH_AS(detail::for_each_block_of_lines(stream, size, visit),
                         "blocks, line 7: a vertex has 3 coordinates, not 2",
                         std::invalid_argument);
    CHECK(joined == text);
  }
}

TEST_CASE("read_obj: a stream that fails is not half a mesh") {
  struct Failing : std::stringbuf {
    int_type underflow() override { throw std::runtime_error("torn out"); }
  } buffer;
  std::istream stream(&buffer);
  CHECK_THROWS_WITH_AS(detail::read_obj(stream, "stick.obj"),
                       doctest::Contains("stick.obj: cannot be read"), std::runtime_error);
}

TEST_CASE("read_obj: refuses a text without faces, whatever it is") {
  check_refused("", "no faces");
  check_refused("v 0 0 0\n", "no faces (1 vertices)");
  std::string junk;
  test::Random rng(8);
  for (int i = 0; i < 100000; ++i) {
    const auto byte = static_cast<unsigned char>(rng.uniform(0, 256));
    junk += static_cast<char>(byte);
  }
  check_refused(junk, "test.obj");
  check_refused(std::string(1 << 20, 'f'), "is not a keyword of OBJ");
  check_refused("v " + std::string(1 << 20, '1') + " 0 0\n", "is not a finite number");
  CHECK_THROWS_WITH_AS(detail::read_obj("/no/such/file.obj"),
                       doctest::Contains("/no/such/file.obj: cannot be read"), std::runtime_error);
  CHECK_THROWS_AS(detail::read_obj("/"), std::runtime_error);
}

TEST_CASE("read_obj: a line of a hundred thousand corners is one face") {
  std::string text = square + "f";
  for (int i = 0; i < 100000; ++i) text += " 1 2 3 4";
  CHECK(read(text).face(0).size() == 400000);
}

TEST_CASE("write_obj, read_obj: give the same bits back") {
  PolygonMesh mesh =
      test::together(test::moved(test::sphere(2), 1e-6, Vec3(1, 2, 3)), test::cube());
  mesh.vertices[0] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), -0.0};
  mesh.vertices[1] = {std::numeric_limits<double>::denorm_min(), 1e-310, 0.1 + 0.2};
  test::Random rng(9);
  for (std::size_t i = 2; i < mesh.vertices.size(); ++i)
    mesh.vertices[i] += rng.vector() * std::pow(10, rng.uniform(-20, 20));
  std::stringstream stream;
  write_obj(stream, mesh);
  const PolygonMesh back = detail::read_obj(stream, "back");
  CHECK(back.corners == mesh.corners);
  CHECK(back.first_corner == mesh.first_corner);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    CHECK(back.vertices[i] == mesh.vertices[i]);
  CHECK(std::signbit(back.vertices[0].z()));
}

TEST_CASE("write_obj: refuses a file that cannot be written") {
  CHECK_THROWS_WITH_AS(write_obj("/no/such/folder/x.obj", test::cube()),
                       doctest::Contains("cannot be written"), std::runtime_error);
}

TEST_CASE("read_obj: a line goes on in the next one behind a backslash") {
  const PolygonMesh whole = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  for (const char* text : {"v 0 0 \\\n0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\n 3 4\n",
                           "v 0 0 0\nv 1 0\\\r\n 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2\\\r\n 3 4\r\n",
                           "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf \\\n1 \\\n2 \\\n3 \\\n4 \\\n"}) {
    const PolygonMesh mesh = read(text);
    CHECK(mesh.corners == whole.corners);
    CHECK(mesh.vertices == whole.vertices);
  }
}

TEST_CASE("read_obj: refuses a word that OBJ does not have, and says which one was meant") {
  const std::string body = square + "f 1 2 3 4\n";
  check_refused("V 0 0 0\n" + body,
                "test.obj, line 1: 'V' is not a keyword of OBJ: did you mean 'v'?");
  check_refused(body + "F 1 2 3\n", "line 6: 'F' is not a keyword of OBJ: did you mean 'f'?");
  check_refused(body + "UseMtl steel\n", "did you mean 'usemtl'?");
  check_refused(body + "MTLLIB a.mtl\n", "did you mean 'mtllib'?");
  for (const std::string word : {"vertex", "face", "call_me", "v:", "4", "//", "\\x"})
    check_refused(body + word + " 1 2 3\n",
                  ("line 6: '" + word + "' is not a keyword of OBJ: put a # before").c_str());
}

TEST_CASE(
    "read_obj: passes over every other keyword of the format, and lines that these go on in") {
  const std::string body = square + "f 1 2 3 4\n";
  for (const std::string_view keyword : detail::obj_passed_over) {
    CAPTURE(keyword);
    CHECK(read(std::string(keyword) + " 1 2 \\\n 3 4 \\\r\n5\n" + body).face_count() == 1);
    CHECK(read(body + std::string(keyword)).face_count() == 1);
  }
  CHECK(read("# C:\\\n" + body + "\\\nf 4 3 2\n").face_count() == 2);  // a comment ends
}

TEST_CASE("read_obj: a comment may follow a number without a blank") {
  const PolygonMesh mesh =
      read("v 0 0 0# c\nv 1 0 0#\nv 0 1 0 1 1 1# c\nf 1 2 3# c\nf 1/1/1 2 3/2#");
  CHECK(mesh.vertices.size() == 3);
  CHECK(mesh.corners == std::vector<int>{0, 1, 2, 0, 1, 2});
  check_refused(square + "f 1 2 3x# c\n", "'3x#'");
  check_refused(square + "f 1 2# 3 4\n", "has 2 corners");
}

TEST_CASE("read_obj: bytes 0 may fill up the end, and hide nothing") {
  CHECK(read(square + "f 1 2 3 4\n" + std::string(99, '\0')).face_count() == 1);
  CHECK(read(square + "f 1 2 3 4\n\x1A").face_count() == 1);
  CHECK(read(square + "f 1 2 3 4\n" + std::string("\0 \0 \n\0", 6)).face_count() == 1);
  check_refused(square + "f 1 2 3 4\n" + std::string("\0 f 1 2 3", 9), "line 6: '\\x00'");
}
