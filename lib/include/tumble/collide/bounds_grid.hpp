#pragma once
/// @file
/// Which of many bounds, that change one at a time, overlap those of one: a grid of cells, of which
/// only the ones in use are stored.
///
/// Where bodies are about as large as a cell, the neighbours of one cost the same however many
/// bodies there are. Source: Teschner et al., "Optimized spatial hashing for collision detection of
/// deformable objects", VMV 2003.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tumble/collide/bounds.hpp"
#include "tumble/core/require.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// Numbered bounds. Those that span many cells are kept in a list of their own.
class BoundsGrid {
 public:
  /// @param count how many bounds there are; all are empty at first
  /// @param cell  edge length of a cell [m]; best about that of most bounds
  /// @throws std::invalid_argument if the cell is not positive and finite
  BoundsGrid(int count, double cell) : cell_(cell) {
    require(cell > 0 && std::isfinite(cell), "bounds grid: the cell ", cell,
            " m is not positive and finite");
    const auto size = static_cast<std::size_t>(count);
    items_.resize(size);
    seen_.resize(size);
    lists_.resize(2 * size + 2);
  }

  const Bounds& operator[](int i) const { return items_[static_cast<std::size_t>(i)]; }

  /// Gives a number other bounds.
  void put(int i, const Bounds& bounds) {
    Bounds& item = items_[static_cast<std::size_t>(i)];
    for_lists(item, [&](List& list) { std::erase(list, i); });
    item = bounds;
    for_lists(item, [&](List& list) { list.push_back(i); });
  }

  /// Shows `visit(j)` each other number whose bounds overlap those of i, once. Bounds that only
  /// touch overlap.
  template <class Visit>
  void overlapping(int i, const Visit& visit) {
    const Bounds& mine = (*this)[i];
    if (mine.isEmpty()) return;
    ++search_;
    const auto look = [&](int j) {
      std::int64_t& seen = seen_[static_cast<std::size_t>(j)];
      if (j != i && seen != search_ && mine.intersects((*this)[j])) visit(j);
      seen = search_;
    };
    if (spans_many(mine)) {
      for (int j = 0; j < static_cast<int>(items_.size()); ++j) look(j);
      return;
    }
    for (const int j : lists_[large]) look(j);
    for_lists(mine, [&](const List& list) { std::for_each(list.begin(), list.end(), look); });
  }

 private:
  using List = std::vector<int>;
  static constexpr std::size_t large = 0;  ///< the list of bounds that span many cells

  /// Whether bounds are kept out of the cells; also where a cell has no number.
  bool spans_many(const Bounds& bounds) const {
    constexpr double many = 64, last = 1e15;
    const Vec3 cells = (bounds.sizes() / cell_).array() + 1;
    const Vec3 farthest = bounds.min().cwiseAbs().cwiseMax(bounds.max().cwiseAbs());
    return !(cells.prod() <= many && farthest.maxCoeff() <= last * cell_);
  }

  /// Each list in which bounds are. Two cells may share one: then it is shown twice.
  template <class Visit>
  void for_lists(const Bounds& bounds, const Visit& visit) {
    if (bounds.isEmpty()) return;
    if (spans_many(bounds)) return visit(lists_[large]);
    using Cell = Eigen::Vector<std::int64_t, 3>;
    const Cell first = (bounds.min() / cell_).array().floor().cast<std::int64_t>();
    const Cell last = (bounds.max() / cell_).array().floor().cast<std::int64_t>();
    for (std::int64_t x = first.x(); x <= last.x(); ++x)
      for (std::int64_t y = first.y(); y <= last.y(); ++y)
        for (std::int64_t z = first.z(); z <= last.z(); ++z) visit(lists_[list_of(x, y, z)]);
  }

  std::size_t list_of(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const auto mixed = [](std::int64_t k, std::uint64_t prime) {
      return static_cast<std::uint64_t>(k) * prime;
    };
    const std::uint64_t hash = mixed(x, 73856093) ^ mixed(y, 19349663) ^ mixed(z, 83492791);
    return 1 + static_cast<std::size_t>(hash % (lists_.size() - 1));
  }

  double cell_;
  std::vector<Bounds> items_;
  std::vector<List> lists_;
  std::vector<std::int64_t> seen_;  ///< the last search that looked at each
  std::int64_t search_ = 0;
};

/// @}

}  // namespace tumble::collide
