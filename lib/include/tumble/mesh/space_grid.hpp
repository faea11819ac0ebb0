#pragma once
/// @file
/// A grid of cells in space, each with the list of the triangles whose box meets it.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {

/// A triangle with the box around it.
struct BoxedTriangle {
  int face;
  std::array<int, 3> vertices;
  Eigen::AlignedBox3d box;
};

/// The cells of a grid in space, as lists of triangles.
class SpaceGrid {
 public:
  using Cell = std::array<int, 3>;

  /// @param triangles not empty
  SpaceGrid(const std::vector<BoxedTriangle>& triangles) {
    for (const BoxedTriangle& t : triangles) box_.extend(t.box);
    const double n = static_cast<double>(triangles.size());
    const Vec3 size = box_.sizes().cwiseMax(1e-9 * box_.sizes().maxCoeff());
    // As many cells as triangles, cubes; fewer, if long triangles would be in too many. (Of roots,
    // the product stays in range: the volume of a small body may not.)
    const double wanted = std::cbrt(size[0] / n) * std::cbrt(size[1]) * std::cbrt(size[2]);
    for (double side = wanted > 0 ? wanted : 1;; side *= 2) {
      for (int k = 0; k < 3; ++k)
        count_[static_cast<std::size_t>(k)] =
            std::max(1, static_cast<int>(std::min(1000.0, std::ceil(size[k] / side))));
      double entries = 0;
      for (const BoxedTriangle& t : triangles) entries += cells_of(t.box);
      if (entries <= 24 * n || cell_count() == 1) break;
    }
    fill(triangles);
  }

  /// Calls `visit(cell, triangles in it)`.
  template <class Visit>
  void for_each_cell(const Visit& visit) const {
    Cell c{};
    for (c[2] = 0; c[2] < count_[2]; ++c[2])
      for (c[1] = 0; c[1] < count_[1]; ++c[1])
        for (c[0] = 0; c[0] < count_[0]; ++c[0]) {
          const std::size_t i = number(c);
          visit(c, std::span<const int>(items_).subspan(first_[i], first_[i + 1] - first_[i]));
        }
  }

  /// How many pairs of triangles have a cell in common, each counted once a cell.
  double pairs() const {
    double sum = 0;
    for_each_cell([&](const Cell&, std::span<const int> items) {
      const auto n = static_cast<double>(items.size());
      sum += n * (n - 1) / 2;
    });
    return sum;
  }

  Cell cell_of(const Vec3& p) const {
    Cell cell{};
    for (int k = 0; k < 3; ++k) {
      const int n = count_[static_cast<std::size_t>(k)];
      const double t = (p[k] - box_.min()[k]) / box_.sizes()[k] * n;
      cell[static_cast<std::size_t>(k)] = static_cast<int>(std::min(std::max(0.0, t), n - 1.0));
    }
    return cell;
  }

 private:
  std::size_t cell_count() const {
    return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
           static_cast<std::size_t>(count_[2]);
  }
  std::size_t number(const Cell& c) const {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    return (at(c[2]) * at(count_[1]) + at(c[1])) * at(count_[0]) + at(c[0]);
  }
  double cells_of(const Eigen::AlignedBox3d& box) const {
    const Cell low = cell_of(box.min()), high = cell_of(box.max());
    double cells = 1;
    for (std::size_t k = 0; k < 3; ++k) cells *= high[k] - low[k] + 1;
    return cells;
  }
  template <class Visit>
  void for_each_cell_of(const Eigen::AlignedBox3d& box, const Visit& visit) const {
    const Cell low = cell_of(box.min()), high = cell_of(box.max());
    Cell c{};
    for (c[2] = low[2]; c[2] <= high[2]; ++c[2])
      for (c[1] = low[1]; c[1] <= high[1]; ++c[1])
        for (c[0] = low[0]; c[0] <= high[0]; ++c[0]) visit(number(c));
  }
  /// Counts the items of each cell, adds up to where its list ends, and fills the lists backwards.
  void fill(const std::vector<BoxedTriangle>& triangles) {
    first_.assign(cell_count() + 1, 0);
    for (const BoxedTriangle& t : triangles)
      for_each_cell_of(t.box, [&](std::size_t cell) { ++first_[cell]; });
    std::size_t sum = 0;
    for (std::size_t& n : first_) n = sum += n;
    items_.resize(sum);
    for (std::size_t i = triangles.size(); i-- > 0;)
      for_each_cell_of(triangles[i].box,
                       [&](std::size_t cell) { items_[--first_[cell]] = static_cast<int>(i); });
  }

  Eigen::AlignedBox3d box_;
  std::array<int, 3> count_{};
  std::vector<std::size_t> first_;
  std::vector<int> items_;
};

/// Calls `visit(s, t)` once for each pair whose boxes meet.
/// @param grid of these triangles
template <class Visit>
void for_each_close_pair(const std::vector<BoxedTriangle>& triangles, const SpaceGrid& grid,
                         const Visit& visit) {
  grid.for_each_cell([&](const SpaceGrid::Cell& cell, std::span<const int> items) {
    for (std::size_t i = 0; i < items.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const BoxedTriangle &s = triangles[static_cast<std::size_t>(items[i])],
                            &t = triangles[static_cast<std::size_t>(items[j])];
        if (!s.box.intersects(t.box)) continue;
        // Of the cells that have this pair, one looks at it.
        if (grid.cell_of(s.box.min().cwiseMax(t.box.min())) == cell) visit(s, t);
      }
  });
}

}  // namespace tumble::detail
