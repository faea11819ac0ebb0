/// @file
/// What it takes: a question whether a point is inside, and the mug's inertia by all methods.

#include "common.hpp"
#include "die.hpp"
#include "parts.hpp"
#include "support/stopwatch.hpp"
#include "typical_errors.hpp"

namespace point_sampling_chapter {

namespace {

/// The solid angle of the mesh seen from p, in whole turns. Source: Van Oosterom & Strackee, "The
/// solid angle of a plane triangle", IEEE Trans. Biomed. Eng. 30 (1983), eq. 8.
double turns_around(const PolygonMesh& mesh, const Vec3& p) {
  double sum = 0;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3 a = mesh.vertex(t[0]) - p, b = mesh.vertex(t[1]) - p, c = mesh.vertex(t[2]) - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  });
  return sum / (2 * pi);
}

/// Whether the upward ray meets more triangles that it leaves through than others: all are looked
/// at.
bool inside_by_looking_at_all(const PolygonMesh& mesh, const Vec3& p) {
  int winding = 0;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3 &a = mesh.vertex(t[0]), &b = mesh.vertex(t[1]), &c = mesh.vertex(t[2]);
    const int crossing = detail::line_crossing(a, b, c, p.x(), p.y());
    if (crossing != 0 && detail::LineWeights(a, b, c, {p.x(), p.y()}).height(a, b, c) > p.z())
      winding += crossing;
  });
  return winding != 0;
}

/// Random points of the mug's box, one after the other, without end.
class Places {
 public:
  Places() {
    sampling::RandomPoints points(4096, 7);
    const Eigen::AlignedBox3d box = mug_solid().bounds();
    for (int i = 0; i < 4096; ++i)
      list_.emplace_back(box.min() + points.next().cwiseProduct(box.sizes()));
  }
  const Vec3& next() { return list_[i_++ % list_.size()]; }

 private:
  std::vector<Vec3> list_;
  std::size_t i_ = 0;
};

}  // namespace

Table inside_table() {
  support::Stopwatch stopwatch;
  const auto add = [&](const std::string& name, auto&& inside, int times) {
    stopwatch.add(
        name, [inside, places = Places()]() mutable { support::keep(inside(places.next())); },
        times);
  };
  add(
      "a ball", [](const Vec3& p) { return Ball{0.04}.contains(p); }, 4096);
  add(
      "a die of 21 pips", [](const Vec3& p) { return die().contains(200 * p); }, 4096);
  add(
      "the mug, triangles in cells", [](const Vec3& p) { return mug_solid().contains(p); }, 4096);
  add(
      "the mug, all triangles", [](const Vec3& p) { return inside_by_looking_at_all(mug(), p); },
      64);
  add(
      "the mug, solid angles", [](const Vec3& p) { return turns_around(mug(), p) > 0.5; }, 16);
  Table table({"is a point inside …", "time", "as a ratio"});
  const std::vector<support::Timing> timings = stopwatch.timings();
  for (const support::Timing& each : timings)
    table.add({each.name, support::duration(each.seconds),
               support::times(each.seconds / timings[2].seconds)});
  return table;
}

// ── All methods ──

Table times_table() {
  support::Stopwatch stopwatch;
  std::vector<std::string> errors;
  const std::vector<Placement> at = placements(16);
  const PolygonMesh mesh = placed_mesh(mug(), at[0]);
  stopwatch.add(
      "exact sum (chapter 8)", [&] { support::keep(unchecked_mass_properties(mesh, mug_density)); },
      1);
  stopwatch.add(
      "the same, mesh checked", [&] { support::keep(mesh_mass_properties(mesh, mug_density)); }, 1);
  errors.resize(2, "< 1e-14");
  for (const std::size_t i : {5u, 4u, 3u, 2u, 1u, 0u})
    for (const std::size_t k : {0u, 3u}) {
      const Method& method = methods()[i];
      const int n = method.numbers[k];
      // Each time another mug: a processor that sees the same points again learns the answers.
      const auto find = [&, n, turn = Seed{0}]() mutable {
        ++turn;
        support::keep(method.find(at[turn % at.size()], n, turn));
      };
      stopwatch.add(number(n, 6) + " " + method.name, find, 1);
      errors.push_back(error_number(all_errors()[i][k]));
    }
  stopwatch.add(
      "triangles into cells, once", [&] { support::keep(MeshSolid(mug())); }, 1);
  errors.emplace_back();
  Table table({"inertia of the mug", "time", "as a ratio", "error"});
  const std::vector<support::Timing> timings = stopwatch.timings();
  for (std::size_t i = 0; i < timings.size(); ++i)
    table.add({timings[i].name, support::duration(timings[i].seconds),
               support::times(timings[i].seconds / timings[0].seconds), errors[i]});
  return table;
}

}  // namespace point_sampling_chapter
