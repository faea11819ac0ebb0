/// @file
/// Signed triangles of an outline: the picture of signed tetrahedra in the plane.

#include "common.hpp"
#include "corner_of_a_cube.hpp"
#include "parts.hpp"
#include "plain_tetrahedra.hpp"

namespace mirtich_chapter {

namespace {

const std::vector<Vec2> arrowhead{{1.2, 0.3}, {3.4, -0.1}, {2.5, 0.9},
                                  {3.3, 2.1}, {1.9, 1.5},  {0.7, 2.0}};

double cross_of(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The triangles of one sign with their apex in the origin.
void draw_signed(support::Sketch& sketch, bool positive) {
  const std::size_t n = arrowhead.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 &p = arrowhead[k], &q = arrowhead[(k + 1) % n];
    if ((cross_of(p, q) > 0) != positive) continue;
    sketch.curve({Vec2(0, 0), p, q, Vec2(0, 0)}, {positive ? "c0" : "c1", 1, 1, 0.28});
  }
}

void draw_body(support::Sketch& sketch, const support::Pen& pen) {
  std::vector<Vec2> line = arrowhead;
  line.push_back(line.front());
  sketch.curve(line, pen);
  for (std::size_t k = 0; k < arrowhead.size(); ++k) {
    const Vec2 p = arrowhead[k], q = arrowhead[(k + 1) % arrowhead.size()];
    const Vec2 middle = (p + q) / 2, along = (q - p).normalized() * 0.12;
    sketch.arrow(middle - along, middle + along, {"ink", 1.6});
  }
}

}  // namespace

namespace {

/// D of each face of the corner of a cube, from some apexes, and the volume.
Table apexes_table(const std::vector<std::pair<std::string, Vec3>>& apexes) {
  const std::array names{"slanted", "x = 0", "y = 0", "z = 0"};
  const PolygonMesh corner = corner_of_a_cube();
  std::vector<std::string> heads{"face"}, last{"volume"};
  for (const auto& [name, p] : apexes) {
    heads.push_back(name);
    last.push_back("1/" + number(1 / integrals(corner, p).one));
  }
  Table table(heads);
  for (int f = 0; f < corner.face_count(); ++f) {
    std::vector<std::string> row{names[static_cast<std::size_t>(f)]};
    const auto v = corner.face(f);
    for (const auto& [name, p] : apexes)
      row.push_back(number(
          six_volumes(corner.vertex(v[0]) - p, corner.vertex(v[1]) - p, corner.vertex(v[2]) - p) +
          0));
    table.add(row);
  }
  table.add(last);
  return table;
}

}  // namespace

Table apex_table() {
  return apexes_table({{"D from (0, 0, 0)", Vec3(0, 0, 0)},
                       {"D from (1, 1, 1)", Vec3(1, 1, 1)},
                       {"D from (2, 0, 0)", Vec3(2, 0, 0)}});
}

Table apex_inside_table() { return apexes_table({{"D from (¼, ¼, ¼)", Vec3(0.25, 0.25, 0.25)}}); }

std::string tetrahedra_figure() {
  support::Sketch sketch(760, 240, "Signed triangles of an outline", 19);
  const std::array<std::string, 3> words{"from behind: plus", "from the front: minus",
                                         "together: the body"};
  for (int panel = 0; panel < 3; ++panel) {
    sketch.look({22 + 252.0 * panel, 160, 66});
    if (panel < 2) draw_signed(sketch, panel == 0);
    draw_body(sketch, {"ink", 2, 1, panel == 2 ? 0.22 : 0});
    sketch.dot({0, 0}, "ink", 5);
    sketch.words({0, 0}, {0, 54}, words[static_cast<std::size_t>(panel)],
                 panel == 0   ? "c0"
                 : panel == 1 ? "c1"
                              : "ink");
  }
  return sketch.svg();
}

}  // namespace mirtich_chapter
