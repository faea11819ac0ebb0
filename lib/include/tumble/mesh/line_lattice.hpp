#pragma once
/// @file
/// Vertical lines, spread over a box so that the ones near a triangle are known at once.
///
/// Line (i, j) is at x = (i + ½) Δx, y = (j + {½ + i s}) Δy. With s = 1/φ the lattice's columns
/// are shifted by the golden ratio, so that no row of a regular mesh slips through it; with s = 0
/// the lines are in the middles of cells. Source: Niederreiter, "Random Number Generation and
/// Quasi-Monte Carlo Methods" (1992), §5.1 (lattice rules in two dimensions).

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tumble/core/rounding.hpp"
#include "tumble/mesh/xy_grid.hpp"
#include "tumble/simd/pack.hpp"

namespace tumble::detail {

/// Which packs of triangles may have a line of a lattice, seen from above: none that has one is
/// left out.
class LatticeFilter {
 public:
  /// @param nx, ny columns and rows of the lattice over the box
  /// @param step   by which each column is shifted, in rows
  LatticeFilter(const Eigen::AlignedBox3d& box, int nx, int ny, double step)
      : low_x_(box.min().x()), low_y_(box.min().y()), step_(step) {
    const double width = box.sizes().x(), height = box.sizes().y();
    per_x_ = nx / width;
    per_y_ = ny / height;
    // The lines' coordinates are rounded, and so is what is computed here.
    slack_x_ = 16 * unit_roundoff * (nx + (std::abs(low_x_) + width) * per_x_);
    slack_y_ = 16 * unit_roundoff * (nx + ny + (std::abs(low_y_) + height) * per_y_);
    useful_ = width > 0 && height > 0 && slack_x_ < 0.1 && slack_y_ < 0.1;
  }

  /// 1 in the lanes whose rectangle may have a line in it, 0 in the others.
  template <class P>
  TUMBLE_INLINE P near(const P& x0, const P& x1, const P& y0, const P& y1) const {
    if (!useful_) return P{} + 1;
    // Column i is at i + ½, where the cells are the unit.
    const P first = simd::rounded((x0 - low_x_) * per_x_ - slack_x_);
    const P columns = simd::rounded((x1 - low_x_) * per_x_ + slack_x_) - first;
    const P low = (y0 - low_y_) * per_y_ - slack_y_, high = (y1 - low_y_) * per_y_ + slack_y_;
    // Counts of columns and rows, cut off at 0 and 1, are a no or a yes.
    P any = at_most_1(columns - 3);
    for (int k = 0; k < 3; ++k)
      any = simd::larger(any, at_most_1(columns - k) * in_column(first + k, low, high));
    return any;
  }

 private:
  template <class P>
  TUMBLE_INLINE static P at_most_1(const P& count) {
    return simd::smaller(simd::larger(count, P{}), P{} + 1);
  }
  /// Whether a line of column i is between low and high: they are at j + ½ + i s, whole turns
  /// left out.
  template <class P>
  TUMBLE_INLINE P in_column(const P& i, const P& low, const P& high) const {
    const P turns = i * step_;
    const P shift = turns - simd::rounded(turns);
    return at_most_1(simd::rounded(high - shift) - simd::rounded(low - shift));
  }

  double low_x_, low_y_, step_, per_x_, per_y_, slack_x_, slack_y_;
  bool useful_;
};

/// Lines in a lattice: one in each cell of a grid.
class LineLattice {
 public:
  /// About `count` lines in columns shifted by the golden ratio, four times as many columns as
  /// rows.
  LineLattice(const Eigen::AlignedBox3d& box, int count)
      : LineLattice(box, XyGrid(box, 2 * side(count), side(count) / 2), 1 / std::numbers::phi) {}

  /// About `count` lines (never more) in the middles of cells as square as whole numbers allow.
  static LineLattice regular(const Eigen::AlignedBox3d& box, int count) {
    return {box, XyGrid(box, static_cast<double>(count)), 0};
  }

  int size() const { return nx_ * ny_; }
  PlanePoint line(int i) const { return {x_[index(i / ny_)], y_[index(i)]}; }
  const LatticeFilter& filter() const { return filter_; }

  /// Calls `visit(i, line(i))` for the lines in a rectangle. (Most rectangles have none: no branch
  /// is taken.)
  template <class Visit>
  void for_each_in(const Rectangle& r, Visit&& visit) const {
    const int c0 = grid_.column(r.x0), c1 = grid_.column(r.x1);
    const int r0 = grid_.row(r.y0), r1 = grid_.row(r.y1);
    const int first = c0 + (x_[index(c0)] < r.x0), last = c1 - (x_[index(c1)] > r.x1);
    for (int column = first; column <= last; ++column) {
      const int i0 = column * ny_ + r0, i1 = column * ny_ + r1;
      const int begin = i0 + (y_[index(i0)] < r.y0), end = i1 - (y_[index(i1)] > r.y1);
      for (int i = begin; i <= end; ++i) {
        const PlanePoint line(x_[index(column)], y_[index(i)]);
        if (r.contains(line)) visit(i, line);
      }
    }
  }

 private:
  LineLattice(const Eigen::AlignedBox3d& box, const XyGrid& grid, double step)
      : nx_(grid.nx()), ny_(grid.ny()), grid_(grid), filter_(box, nx_, ny_, step) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (int i = 0; i < nx_; ++i) {
      const double shift = 0.5 + i * step;
      const double x = box.min().x() + box.sizes().x() * ((i + 0.5) / nx_);
      x_.push_back(grid_.column(x) == i ? x : infinity);
      for (int j = 0; j < ny_; ++j) {
        const double y = box.min().y() + box.sizes().y() * ((j + shift - std::floor(shift)) / ny_);
        y_.push_back(grid_.row(y) == j ? y : infinity);  // where rounding is as coarse as the cells
      }
    }
  }

  static int side(int count) { return static_cast<int>(std::sqrt(count)); }
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  int nx_, ny_;
  XyGrid grid_;
  LatticeFilter filter_;
  std::vector<double> x_, y_;
};

/// Lines anywhere.
class LineList {
 public:
  LineList(const Eigen::AlignedBox3d& box, std::vector<PlanePoint> lines)
      : lines_(std::move(lines)),
        grid_(box, static_cast<double>(lines_.size())),
        bins_(grid_, size(), [this](int i) {
          const int column = grid_.column(line(i).x()), row = grid_.row(line(i).y());
          return CellRange{column, column, row, row};
        }) {}

  int size() const { return static_cast<int>(lines_.size()); }
  const PlanePoint& line(int i) const { return lines_[static_cast<std::size_t>(i)]; }

  /// Calls `visit(i, line(i))` for the lines in a rectangle.
  template <class Visit>
  void for_each_in(const Rectangle& r, Visit&& visit) const {
    const int c0 = grid_.column(r.x0), c1 = grid_.column(r.x1), r1 = grid_.row(r.y1);
    for (int row = grid_.row(r.y0); row <= r1; ++row)
      for (int column = c0; column <= c1; ++column)
        for (const int i : bins_.items(column, row))
          if (r.contains(line(i))) visit(i, line(i));
  }

 private:
  std::vector<PlanePoint> lines_;
  XyGrid grid_;
  XyBins bins_;
};

}  // namespace tumble::detail
