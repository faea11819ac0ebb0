/// @file
/// A ray that meets an edge: what becomes of a cube when it counts twice, never, or once.

#include "common.hpp"
#include "die.hpp"
#include "outline.hpp"
#include "parts.hpp"

namespace point_sampling_chapter {

namespace {

/// Whether the vertical line through p meets the triangle, by the rule.
bool meets(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p, EdgeRule rule) {
  if (rule == EdgeRule::one) return detail::line_crossing(a, b, c, p.x(), p.y()) != 0;
  const auto side = [&p](const Vec3& from, const Vec3& to) {
    return detail::orientation(from.x(), from.y(), to.x(), to.y(), p.x(), p.y());
  };
  const int ab = side(a, b), bc = side(b, c), ca = side(c, a);
  const int low = std::min({ab, bc, ca}), high = std::max({ab, bc, ca});
  if (rule == EdgeRule::both) return (low >= 0 && high > 0) || (high <= 0 && low < 0);
  return low == high && low != 0;
}

/// Whether the ray up from p meets an odd number of triangles. (The faces above or below p are
/// level in this table's bodies.)
bool odd_hits_above(const PolygonMesh& mesh, const Vec3& p, EdgeRule rule) {
  bool odd = false;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3 &a = mesh.vertex(t[0]), &b = mesh.vertex(t[1]), &c = mesh.vertex(t[2]);
    if (a.z() > p.z() && b.z() > p.z() && c.z() > p.z() && meets(a, b, c, p, rule)) odd = !odd;
  });
  return odd;
}

/// A box from the origin, of triangles.
PolygonMesh box_of_triangles(const Vec3& size) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(size.cwiseProduct(Vec3(i & 1, i >> 1 & 1, i >> 2 & 1)));
  const auto add = [&mesh](int a, int b, int c, int d) {
    mesh.add_face({a, b, c}), mesh.add_face({a, c, d});
  };
  add(0, 2, 3, 1), add(4, 5, 7, 6), add(0, 1, 5, 4), add(2, 6, 7, 3), add(0, 4, 6, 2),
      add(1, 3, 7, 5);
  return mesh;
}

/// The points of a grid of n³ cells in the box.
std::vector<Vec3> grid_in(const Vec3& size, int n) {
  std::vector<Vec3> list;
  sampling::GridPoints points(n);
  for (std::int64_t i = 0; i < points.count(); ++i)
    list.emplace_back(points.next().cwiseProduct(size));
  return list;
}

/// What of a cube and a box n³ points find, by each rule.
Table by_rules(int n) {
  Table table({"a ray through an edge", "points inside", "cube of 1 kg", "box of 6 kg", "off by"});
  const auto add = [&](const std::string& name, EdgeRule rule) {
    std::vector<std::string> row{name};
    double share = 0;
    for (const Vec3& size : {Vec3(1, 1, 1), Vec3(1, 2, 3)}) {
      int inside = 0;
      for (const Vec3& p : grid_in(size, n))
        inside += odd_hits_above(box_of_triangles(size), p, rule);
      share = static_cast<double>(inside) / (n * n * n);
      if (row.size() == 1) row.push_back(number(inside, 6));
      row.push_back(number(share * size.prod(), 5) + " kg");
    }
    row.push_back(percent(1 - share, 4));
    table.add(row);
  };
  add("counts for both triangles", EdgeRule::both);
  add("counts for none", EdgeRule::none);
  add("counts for one", EdgeRule::one);
  return table;
}

}  // namespace

Table edge_table() { return by_rules(32); }

Table edge_31_table() { return by_rules(31); }

std::string edge_figure() {
  constexpr int n = 32;
  support::Sketch sketch(640, 372,
                         "The cube from above: columns of points that a careless rule loses", 20);
  const std::array<EdgeRule, 2> rules{EdgeRule::none, EdgeRule::one};
  const std::array<std::string, 2> names{"an edge counts twice, or never", "an edge counts once"};
  const PolygonMesh cube = box_of_triangles(Vec3(1, 1, 1));
  for (std::size_t k = 0; k < 2; ++k) {
    sketch.look({12 + 320 * static_cast<double>(k), 312, 300});
    sketch.frame({0, 0}, {1, 1}, {"faint", 1});
    sketch.curve({{0, 0}, {1, 1}}, {"faint", 1});
    std::vector<Vec2> kept, lost;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Vec3 p((i + 0.5) / n, (j + 0.5) / n, 0.5);
        (odd_hits_above(cube, p, rules[k]) ? kept : lost).emplace_back(p.head<2>());
      }
    sketch.specks(kept, "c0", 2.4);
    sketch.specks(lost, "c1", 4.4);
    sketch.words({0.5, 0}, {0, 34}, names[k], "ink", "middle");
  }
  return sketch.svg();
}

}  // namespace point_sampling_chapter
