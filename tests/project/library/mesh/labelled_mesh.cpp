// What an OBJ file calls its faces.
#include "tumble/mesh/labelled_mesh.hpp"

#include <doctest/doctest.h>

#include "tumble/mesh/parse_mesh.hpp"

using namespace tumble;

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", a_face = "f 1 2 3\n";

parts::LabelledMesh labelled(const std::string& text) { return parse_mesh(text, "test.obj"); }

/// "object|group|material"
std::string text_of(const parts::Label& label) {
  return label.object + "|" + label.group + "|" + label.material;
}

/// The same of each face.
std::vector<std::string> names_in(const parts::LabelledMesh& mesh) {
  std::vector<std::string> names;
  for (const auto& [first, end, label] : mesh.ranges) {
    CHECK(first == static_cast<int>(names.size()));
    CHECK(first < end);
    names.resize(static_cast<std::size_t>(end),
                 text_of(mesh.labels.at(static_cast<std::size_t>(label))));
  }
  CHECK(static_cast<int>(names.size()) == mesh.face_count());
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("labels: hold until another one comes, each kind by itself") {
  const parts::LabelledMesh mesh = labelled(
      corners + a_face + "o hammer\ng head\nusemtl steel\n" + a_face + a_face + "g handle\n" +
      a_face + "usemtl wood\n" + a_face + "o nail\nusemtl steel\n" + a_face);
  CHECK(names_in(mesh) == Names{"||", "hammer|head|steel", "hammer|head|steel",
                                "hammer|handle|steel", "hammer|handle|wood", "nail|handle|steel"});
  CHECK(mesh.ranges.size() == 5);
}

TEST_CASE("labels: a mesh without names has one, that is empty") {
  const std::string stl =
      "solid x\nfacet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex "
      "0 1 0 endloop endfacet\nendsolid x\n";
  for (const parts::LabelledMesh& mesh : {labelled(corners + a_face), parse_mesh(stl, "x.stl")}) {
    CHECK(names_in(mesh) == Names{"||"});
    CHECK(mesh.labels.size() == 1);
  }
  CHECK(parts::LabelledMesh(PolygonMesh{}).ranges.empty());
}

TEST_CASE("labels: a name is the rest of its line, without the blanks around it") {
  CHECK(names_in(labelled(corners + "o  My hammer #2 \t\r\ng\ta  b\nusemtl C:\\x\\\n" + a_face)) ==
        Names{"My hammer #2|a  b|C:\\x\\"});
  CHECK(names_in(labelled(corners + "\t usemtl caf\xC3\xA9\n" + a_face)) == Names{"||caf\xC3\xA9"});
}

TEST_CASE("labels: a keyword alone takes the name away, and other words set none") {
  CHECK(names_in(labelled(corners + "g a\no b\nusemtl c\n" + a_face + "g\no \nusemtl\n" +
                          a_face)) == Names{"b|a|c", "||"});
  CHECK(names_in(labelled(corners + "usemap d\nmg a\no\n" + a_face)) == Names{"||"});
  for (const char* line : {"group a", "obj b", "usemtlx c", "Ga", "u"})
    CHECK_THROWS_AS(labelled(corners + line + "\n" + a_face), std::invalid_argument);
  CHECK(names_in(labelled(corners + a_face + "g late")) == Names{"||"});
}

TEST_CASE("labels: each once, and a range goes on where nothing has changed") {
  const parts::LabelledMesh mesh =
      labelled(corners + "usemtl a\n" + a_face + "usemtl b\nusemtl a\n" + a_face + "usemtl b\n" +
               a_face + "usemtl a\n" + a_face);
  CHECK(mesh.labels == std::vector<parts::Label>{{"", "", "a"}, {"", "", "b"}});
  CHECK(mesh.ranges.size() == 3);
  CHECK(names_in(mesh) == Names{"||a", "||a", "||b", "||a"});
}
