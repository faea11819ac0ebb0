#pragma once
/// @file
/// Vertical lines at random, one in each cell of a grid over a box.

#include <vector>

#include "tumble/core/random_fraction.hpp"
#include "tumble/mesh/xy_grid.hpp"

namespace tumble::detail {

/// One line somewhere in each cell, the cells as square as whole numbers allow.
class JitteredLines {
 public:
  /// About `count` lines, never more; the same seed gives the same ones. The box has to be in the
  /// middle of its coordinates, so that rounding is much finer than the cells.
  JitteredLines(const Eigen::AlignedBox3d& box, int count, std::uint64_t seed)
      : grid_(box, static_cast<double>(count)) {
    std::mt19937_64 engine(seed);
    const PlanePoint low = box.min().head<2>(), size = box.sizes().head<2>();
    lines_.reserve(static_cast<std::size_t>(grid_.nx()) * static_cast<std::size_t>(grid_.ny()));
    for (int row = 0; row < grid_.ny(); ++row) {
      for (int column = 0; column < grid_.nx(); ++column) {
        const double u = random_fraction_of_part(engine, column, grid_.nx());
        const double v = random_fraction_of_part(engine, row, grid_.ny());
        const PlanePoint line = low + size.cwiseProduct(PlanePoint(u, v));
        const PlanePoint middle((column + 0.5) / grid_.nx(), (row + 0.5) / grid_.ny());
        // Rounding may take a line over the border of its cell, once in 10¹³.
        lines_.push_back(is_in_cell(line, column, row) ? line : low + size.cwiseProduct(middle));
      }
    }
  }

  int size() const { return static_cast<int>(lines_.size()); }
  const PlanePoint& line(int i) const { return lines_[static_cast<std::size_t>(i)]; }

  /// Calls `visit(i, line(i))` for the lines in a rectangle.
  template <class Visit>
  void for_each_in(const Rectangle& r, Visit&& visit) const {
    const int c0 = grid_.column(r.x0), c1 = grid_.column(r.x1), r1 = grid_.row(r.y1);
    for (int row = grid_.row(r.y0); row <= r1; ++row)
      for (int i = row * grid_.nx() + c0; i <= row * grid_.nx() + c1; ++i)
        if (r.contains(line(i))) visit(i, line(i));
  }

 private:
  bool is_in_cell(const PlanePoint& line, int column, int row) const {
    return grid_.column(line.x()) == column && grid_.row(line.y()) == row;
  }

  XyGrid grid_;
  std::vector<PlanePoint> lines_;
};

}  // namespace tumble::detail
