#pragma once

#include "tumble/mesh/triangle_columns.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<FaceTriangle> face_triangles(const PolygonMesh& mesh) {
  std::vector<FaceTriangle> list;
  list.reserve(mesh.corners.size() / 3);
  for_each_triangle(mesh, [&](int f, const std::array<int, 3>& t) { list.push_back({f, t}); });
  return list;
}

inline Rectangle rectangle_in(const View& view, const PolygonMesh& mesh, const FaceTriangle& t) {
  const auto corner = [&](std::size_t k) { return view.point(mesh.vertex(t.vertices[k])); };
  return rectangle_of(corner(0), corner(1), corner(2));
}

TUMBLE_BODY std::vector<FaceTriangle> those_over(const PolygonMesh& mesh,
                                                 const std::vector<FaceTriangle>& triangles,
                                                 const View& view, const Rectangle& where) {
  std::vector<FaceTriangle> result;
  for (const FaceTriangle& triangle : triangles)
    if (rectangle_in(view, mesh, triangle).meets(where)) result.push_back(triangle);
  return result;
}

TUMBLE_BODY TriangleColumns::TriangleColumns(const PolygonMesh& mesh,
                                             const std::vector<FaceTriangle>& triangles,
                                             const View& view, const Eigen::AlignedBox3d& box)
    : mesh_(mesh),
      triangles_(triangles),
      view_(view),
      grid_(view.box(box), static_cast<double>(triangles.size())),
      bins_(grid_, static_cast<int>(triangles.size()), [this](int i) {
        const CellRange columns = columns_of(rectangle(static_cast<std::size_t>(i)));
        return is_wide(columns) ? CellRange{0, -1, 0, -1} : columns;
      }) {
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (is_wide(columns_of(rectangle(i)))) wide_.push_back(static_cast<int>(i));
}

TUMBLE_BODY Rectangle TriangleColumns::rectangle(std::size_t i) const {
  return rectangle_in(view_, mesh_, triangles_[i]);
}

TUMBLE_BODY CellRange TriangleColumns::columns_of(const Rectangle& r) const {
  return {grid_.column(r.x0), grid_.column(r.x1), grid_.row(r.y0), grid_.row(r.y1)};
}

TUMBLE_BODY std::vector<int> TriangleColumns::candidates(const Rectangle& where) const {
  std::vector<int> found = wide_;
  const CellRange columns = columns_of(where);
  for (int row = columns.y0; row <= columns.y1; ++row)
    for (int column = columns.x0; column <= columns.x1; ++column) {
      const std::span<const int> here = bins_.items(column, row);
      found.insert(found.end(), here.begin(), here.end());
    }
  return found;
}

TUMBLE_BODY std::vector<FaceTriangle> TriangleColumns::over(const Rectangle& where) const {
  std::vector<int> found = candidates(where);
  if (found.size() > triangles_.size() / 8)  // to sort so many is slower
    return those_over(mesh_, triangles_, view_, where);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<FaceTriangle> chosen;
  chosen.reserve(found.size());
  for (const int i : found) chosen.push_back(triangles_[static_cast<std::size_t>(i)]);
  return those_over(mesh_, chosen, view_, where);
}

}  // namespace tumble::detail
