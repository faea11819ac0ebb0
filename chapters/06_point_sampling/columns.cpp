/// @file
/// Columns through the mug: where they enter and where they leave.

#include "common.hpp"
#include "die.hpp"
#include "parts.hpp"

namespace point_sampling_chapter {

namespace {

/// Where the vertical line through (x, y) meets the mug, from below.
std::vector<std::pair<double, int>> crossings(double x, double y) {
  std::vector<std::pair<double, int>> list;
  for_each_triangle(mug(), [&](int, const std::array<int, 3>& t) {
    const Vec3 &a = mug().vertex(t[0]), &b = mug().vertex(t[1]), &c = mug().vertex(t[2]);
    const int crossing = detail::line_crossing(a, b, c, x, y);
    if (crossing != 0)
      list.emplace_back(detail::LineWeights(a, b, c, {x, y}).height(a, b, c), crossing);
  });
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

std::string columns_figure() {
  support::Sketch sketch(700, 450, "Columns through a mug");
  const Eigen::AlignedBox3d box = mug_solid().bounds();
  constexpr double scale = 4300, y = 0.0007;
  sketch.look({96 - scale * box.min().x(), 428 + scale * box.min().z(), scale});
  std::vector<std::vector<Vec2>> through, inside;
  std::vector<Vec2> enter, leave;
  constexpr int n = 40;
  for (int i = 0; i < n; ++i) {
    const double x = box.min().x() + box.sizes().x() * (i + 0.5) / n;
    through.push_back({{x, box.min().z()}, {x, box.max().z()}});
    double last = 0;
    for (const auto& [z, crossing] : crossings(x, y)) {
      (crossing > 0 ? leave : enter).emplace_back(x, z);
      if (crossing > 0) inside.push_back({{x, last}, {x, z}});
      last = z;
    }
  }
  sketch.curves(through, {"grid", 1});
  sketch.curves(inside, {"solid", 6});
  sketch.dots(enter, "c1", 3);
  sketch.dots(leave, "c0", 3);
  const Vec2 middle(-0.001, 0.055);
  sketch.words(middle, {0, 0}, "+ where a column leaves", "c0", "middle");
  sketch.words(middle, {0, 28}, "− where it enters", "c1", "middle");
  return sketch.svg();
}

}  // namespace point_sampling_chapter
