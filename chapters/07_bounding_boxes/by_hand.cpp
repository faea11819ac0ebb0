/// @file
/// What the page asks its reader to predict: small enough for paper.

#include "common.hpp"
#include "parts.hpp"

namespace bounding_boxes_chapter {

namespace {

std::string three(const Vec3& v, int digits = 3) {
  return "(" + svg_number(v.x(), digits) + ", " + svg_number(v.y(), digits) + ", " +
         svg_number(v.z(), digits) + ") m";
}

Vec3 mean_of(const Points& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

}  // namespace

Table corners_table() {
  Table table({"the three points and …", "centre of the box", "size", "mean"});
  Points points{{1, 2, 3}, {4, 0, 5}, {2, 6, 1}};
  const auto add = [&](const std::string& name) {
    const boxes::OrientedBox box = boxes::aligned_box(points);
    table.add({name, three(box.centre), three(box.size), three(mean_of(points), 2)});
  };
  add("nothing else");
  for (int i = 0; i < 1000; ++i) points.emplace_back(4, 0, 5);
  add("(4, 0, 5) a thousand times");
  return table;
}

Table diamond_table() {
  Points points;
  for (const double z : {-0.5, 0.5})
    for (const double sign : {-1., 1.})
      for (const Vec2& p : {Vec2(2, 1), Vec2(-0.5, 1)})
        points.emplace_back(sign * p.x(), sign * p.y(), z);
  Table table({"box", "edges", "volume"});
  const auto add = [&table](const std::string& name, const boxes::OrientedBox& box) {
    table.add({name,
               number(box.size.maxCoeff()) + " × " +
                   number(box.volume() / box.size.maxCoeff() / box.size.minCoeff()) + " × " +
                   number(box.size.minCoeff()) + " m",
               number(box.volume()) + " m³"});
  };
  add("along the axes", boxes::aligned_box(points));
  add("along the principal axes", boxes::principal_box(points));
  return table;
}

}  // namespace bounding_boxes_chapter
