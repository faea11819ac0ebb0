/// @file
/// Signed tetrahedra of the corner of a cube, from several apexes.

#include "common.hpp"
#include "corner_of_a_cube.hpp"
#include "parts.hpp"
#include "plain_tetrahedra.hpp"

namespace mirtich_chapter {

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

}  // namespace mirtich_chapter
