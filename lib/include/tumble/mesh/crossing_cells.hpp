#pragma once
/// @file
/// How large is the volume that counts wrongly where a surface crosses itself?
///
/// The length of wrong depth on lines that are spread evenly, times the area that each stands for,
/// is a volume. Where few lines have found a crossing, many more are drawn round them, and round
/// what these find, until its border is reached: the result hardly depends on where the first lines
/// happened to pass, nor on how the body lies. Source: stratified sampling, e.g. Cochran, "Sampling
/// Techniques" (3rd ed. 1977), §5.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tumble/core/random_fraction.hpp"
#include "tumble/mesh/line_bundle.hpp"
#include "tumble/mesh/searched_mesh.hpp"

namespace tumble::detail {

/// A volume that counts wrongly, and twice its standard error [m³].
struct WrongVolume {
  double volume = 0, uncertainty = 0;
};

/// Sums up what the lines of one cell, or of a lattice, say.
class WrongLengths {
 public:
  void add(double length) {
    sum_ += length;
    squares_ += length * length;
  }
  /// @param lines how many there are, with and without wrong depth
  /// @param area  that all of them stand for [m²]
  WrongVolume volume(double lines, double area) const {
    const double mean = sum_ / lines, variance = std::max(0.0, squares_ / lines - mean * mean);
    return {area * mean, 2 * area * std::sqrt(variance / lines)};
  }

 private:
  double sum_ = 0, squares_ = 0;
};

/// The wrong length of each line, in the order of the lines.
template <class Counts>
std::vector<double> wrong_lengths(const LineHits& hits, const Counts& counts) {
  std::vector<double> lengths(hits.line_count(), 0);
  for (const WrongDepth& wrong : find_wrong_depths(hits))
    if (counts(wrong)) lengths[wrong.line] += wrong.excess() * wrong.length;
  return lengths;
}

/// Draws lines through cells of a view where a crossing was seen, and through their neighbours.
/// @tparam Counts counts(WrongDepth): whether a piece of a line belongs to the crossing
template <class Counts>
class CrossingCells {
 public:
  /// @param cells how many the box is cut into
  CrossingCells(SearchedMesh& on, const View& view, const Eigen::AlignedBox3d& box, double cells,
                const Counts& counts)
      : on_(on),
        what_(on.lines(view)),
        box_(view.box(box)),
        grid_(box_, cells),
        counts_(counts),
        known_(static_cast<std::size_t>(grid_.nx()) * static_cast<std::size_t>(grid_.ny())) {}

  /// Looks at the cell of a point, and at those around it.
  void begin_at(const PlanePoint& p) { add_around(grid_.column(p.x()), grid_.row(p.y())); }

  /// Goes on until the crossing is surrounded, or so large that it need not be.
  WrongVolume measure() {
    near_ = on_.over(what_.view, with_margin(box_, width(), height()));
    WrongVolume all;
    double squares = 0;
    while (!next_.empty() && measured_ < most_cells) {
      const std::vector<Cell> cells = std::move(next_);
      next_.clear();
      const std::vector<PlanePoint> lines = lines_through(cells);
      const std::vector<double> lengths = lengths_on(lines);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        WrongLengths in_cell;
        for (std::size_t k = i * per_cell; k < (i + 1) * per_cell; ++k) {
          in_cell.add(lengths[k]);
          if (lengths[k] > 0) extent_.extend(Vec3(lines[k].x(), lines[k].y(), 0));
        }
        const WrongVolume found = in_cell.volume(per_cell, cell_area());
        if (found.volume > 0) add_around(cells[i].column, cells[i].row);
        all.volume += found.volume;
        squares += found.uncertainty * found.uncertainty;
      }
      measured_ += cells.size();
    }
    all.uncertainty = std::sqrt(squares);
    return all.volume > 0 ? better_of(all, measure_extent()) : WrongVolume{0, unseen()};
  }

 private:
  struct Cell {
    int column, row;
  };
  static constexpr int side = 6;
  static constexpr std::size_t per_cell = side * side, most_cells = 4096;

  static Rectangle with_margin(const Eigen::AlignedBox3d& box, double x, double y) {
    return {box.min().x() - x, box.max().x() + x, box.min().y() - y, box.max().y() + y};
  }
  double width() const { return box_.sizes().x() / grid_.nx(); }
  double height() const { return box_.sizes().y() / grid_.ny(); }
  double cell_area() const { return width() * height(); }

  void add_around(int column, int row) {
    for (int r = std::max(0, row - 1); r <= std::min(grid_.ny() - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(grid_.nx() - 1, column + 1); ++c) {
        const auto i = static_cast<std::size_t>(r) * static_cast<std::size_t>(grid_.nx()) +
                       static_cast<std::size_t>(c);
        if (known_[i]) continue;
        known_[i] = true;
        next_.push_back({c, r});
      }
  }

  /// What may be there although no line has met it: of n lines that see nothing, one in n/3 might
  /// have, with 95 %. Source: the "rule of three", e.g. Hanley & Lippman-Hand, JAMA 249 (1983).
  double unseen() const { return 3.0 / per_cell * cell_area() * box_.sizes().z(); }

  static WrongVolume better_of(const WrongVolume& a, const WrongVolume& b) {
    return b.uncertainty * a.volume < a.uncertainty * b.volume ? b : a;
  }

  /// Lines over all of the rectangle in which the crossing was found.
  WrongVolume measure_extent() {
    constexpr int n = 48;
    const Vec3 margin(2 * width() / side, 2 * height() / side, 0);
    const Eigen::AlignedBox3d box(extent_.min() - margin, extent_.max() + margin);
    std::vector<PlanePoint> lines;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) lines.push_back(point_in(box, i, j, n));
    WrongLengths all;
    for (const double length :
         wrong_lengths(hits_of_lines(what_, LineList(box, lines), near_), counts_))
      all.add(length);
    return all.volume(n * n, box.sizes().x() * box.sizes().y());
  }

  std::vector<double> lengths_on(const std::vector<PlanePoint>& lines) const {
    Eigen::AlignedBox3d box;
    for (const PlanePoint& line : lines) box.extend(Vec3(line.x(), line.y(), 0));
    return wrong_lengths(hits_of_lines(what_, LineList(box, lines), near_), counts_);
  }

  /// A point at random in piece (i, j) of n × n.
  PlanePoint point_in(const Eigen::AlignedBox3d& box, int i, int j, int n) {
    const double u = (i + random_fraction(engine_)) / n, v = (j + random_fraction(engine_)) / n;
    return {box.min().x() + u * box.sizes().x(), box.min().y() + v * box.sizes().y()};
  }

  Eigen::AlignedBox3d box_of(const Cell& cell) const {
    const Vec3 low = box_.min() + Vec3(cell.column * width(), cell.row * height(), 0);
    return {low, low + Vec3(width(), height(), 0)};
  }

  /// One at random in each of the pieces that a cell is cut into.
  std::vector<PlanePoint> lines_through(const std::vector<Cell>& cells) {
    std::vector<PlanePoint> lines;
    lines.reserve(cells.size() * per_cell);
    for (const Cell& cell : cells)
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) lines.push_back(point_in(box_of(cell), i, j, side));
    return lines;
  }

  SearchedMesh& on_;
  LinesOnMesh what_;
  Eigen::AlignedBox3d box_;
  XyGrid grid_;
  std::vector<FaceTriangle> near_;  // all that lines in the cells, or beside them, may meet
  Counts counts_;
  std::vector<bool> known_;
  std::vector<Cell> next_;
  std::size_t measured_ = 0;
  Eigen::AlignedBox3d extent_;  // of the lines with wrong depth, seen from above
  std::mt19937_64 engine_{1};
};

/// What the lines of a lattice say by themselves.
template <class Counts>
WrongVolume volume_by_lattice(const LineHits& hits, const Eigen::AlignedBox3d& box,
                              const Counts& counts) {
  WrongLengths all;
  for (const double length : wrong_lengths(hits, counts)) all.add(length);
  return all.volume(static_cast<double>(hits.line_count()), box.sizes().x() * box.sizes().y());
}

}  // namespace tumble::detail
