#pragma once
/// @file
/// A grid of cells over the xy plane, each with the list of the items whose box meets it.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "tumble/core/types.hpp"

namespace tumble::detail {

using PlanePoint = Eigen::Vector2d;

/// A rectangle of the xy plane, its edges included.
struct Rectangle {
  double x0, x1, y0, y1;

  bool contains(const PlanePoint& p) const {
    return x0 <= p.x() && p.x() <= x1 && y0 <= p.y() && p.y() <= y1;
  }
  bool meets(const Rectangle& other) const {
    return x0 <= other.x1 && other.x0 <= x1 && y0 <= other.y1 && other.y0 <= y1;
  }
};

/// What a triangle covers, seen from above.
inline Rectangle rectangle_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  // In pairs: std::min of a list would be compiled to branches.
  return {std::min(std::min(a.x(), b.x()), c.x()), std::max(std::max(a.x(), b.x()), c.x()),
          std::min(std::min(a.y(), b.y()), c.y()), std::max(std::max(a.y(), b.y()), c.y())};
}

/// Where a rectangle of the xy plane is cut into nx × ny cells.
class XyGrid {
 public:
  /// Cuts the xy extent of `box` into about `cells` cells, as square as whole numbers allow.
  XyGrid(const Eigen::AlignedBox3d& box, double cells)
      : XyGrid(box, count(std::sqrt(cells * (box.sizes().x() / box.sizes().y())), cells), cells) {}

  /// Cuts it into nx × ny cells.
  XyGrid(const Eigen::AlignedBox3d& box, int nx, int ny)
      : low_x_(box.min().x()), low_y_(box.min().y()), nx_(nx), ny_(ny) {
    const double width = box.sizes().x(), height = box.sizes().y();
    per_x_ = width > 0 ? nx_ / width : 0;
    per_y_ = height > 0 ? ny_ / height : 0;
  }

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  /// The column and the row of a coordinate. Never decreasing in it, and always a column of the
  /// grid: two things with a common coordinate have a common cell, whatever the rounding.
  int column(double x) const { return place((x - low_x_) * per_x_, nx_); }
  int row(double y) const { return place((y - low_y_) * per_y_, ny_); }

 private:
  XyGrid(const Eigen::AlignedBox3d& box, int nx, double cells)
      : XyGrid(box, nx, count(cells / nx, cells)) {}
  static int count(double wanted, double max_count) {
    return wanted > 1 ? static_cast<int>(std::min(wanted, max_count)) : 1;
  }
  static int place(double t, int n) {
    // 0 for NaN; no branches.
    return static_cast<int>(std::min(std::max(0.0, t), n - 1.0));
  }

  double low_x_, low_y_, per_x_ = 0, per_y_ = 0;
  int nx_, ny_;
};

/// A rectangle of cells, both ends included.
struct CellRange {
  int x0, x1, y0, y1;
};

/// Items by cell: one array of all lists, one after the other.
class XyBins {
 public:
  /// @param item_range the cells of item i, a CellRange, for i = 0 … item_count − 1
  template <class ItemRange>
  XyBins(const XyGrid& grid, int item_count, const ItemRange& item_range)
      : nx_(grid.nx()),
        first_(static_cast<std::size_t>(grid.nx()) * static_cast<std::size_t>(grid.ny()) + 1) {
    // Count the items of each cell, add up to where its list ends, then fill the lists backwards.
    for (int i = 0; i < item_count; ++i)
      for_each_cell(item_range(i), [&](std::size_t cell) { ++first_[cell]; });
    std::size_t sum = 0;
    for (std::size_t& n : first_) n = sum += n;
    items_.resize(sum);
    for (int i = item_count; i-- > 0;)
      for_each_cell(item_range(i), [&](std::size_t cell) { items_[--first_[cell]] = i; });
  }

  /// The items of a cell, in increasing order.
  std::span<const int> items(int column, int row) const {
    const std::size_t cell = cell_index(column, row);
    return std::span<const int>(items_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }

 private:
  std::size_t cell_index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(nx_) +
           static_cast<std::size_t>(column);
  }
  template <class Visit>
  void for_each_cell(const CellRange& r, const Visit& visit) const {
    for (int row = r.y0; row <= r.y1; ++row)
      for (int column = r.x0; column <= r.x1; ++column) visit(cell_index(column, row));
  }

  int nx_;
  std::vector<std::size_t> first_;
  std::vector<int> items_;
};

}  // namespace tumble::detail
