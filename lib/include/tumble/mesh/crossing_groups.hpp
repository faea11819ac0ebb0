#pragma once
/// @file
/// Crossings that lie apart: each pair of parts has one, and a part has one with itself. In an
/// assembly they may be small and far from each other, so each is measured by itself.

#include <map>
#include <utility>
#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/crossing_cells.hpp"
#include "tumble/mesh/crossing_pairs.hpp"

namespace tumble::detail {

/// The places where triangles meet, by the parts that they belong to.
class CrossingGroups {
 public:
  CrossingGroups(const PolygonMesh& mesh, const Components& surface,
                 const TriangleMeetings& meetings);

  /// Those where triangles pass through each other come first, the largest of them before.
  const std::vector<TriangleMeetings>& list() const { return list_; }

  /// To which of them a piece of a line belongs; the length of the list: to none.
  std::size_t owner(const WrongDepth& wrong) const;

 private:
  std::vector<TriangleMeetings> list_;
  std::map<std::pair<int, int>, std::size_t> of_parts_;
  std::map<int, std::size_t> of_part_;  ///< the first that has it
};

/// Sums up the volumes of crossings. The first are all measured; of many more, which are smaller,
/// some are drawn, one in each piece of the list. Source: systematic sampling, e.g. Cochran,
/// "Sampling Techniques" (3rd ed. 1977), §8.1.
/// @param measure measure(k): the WrongVolume of the k-th
template <class Measure>
WrongVolume sum_over_crossings(std::size_t count, const Measure& measure) {
  constexpr std::size_t most = 64;
  WrongVolume all;
  double squares = 0;
  const std::size_t first = std::min(count, most);
  for (std::size_t k = 0; k < first; ++k) {
    const WrongVolume one = measure(k);
    all.volume += one.volume;
    squares += one.uncertainty * one.uncertainty;
  }
  const std::size_t left = count - first, step = (left + most - 1) / most;
  if (left > 0) {
    WrongLengths drawn;
    std::size_t number = 0;
    for (std::size_t k = first + step / 2; k < count; k += step, ++number)
      drawn.add(measure(k).volume);
    const WrongVolume others = drawn.volume(static_cast<double>(number), static_cast<double>(left));
    all.volume += others.volume;
    squares += others.uncertainty * others.uncertainty;
  }
  all.uncertainty = std::sqrt(squares);
  return all;
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/crossing_groups.inl"
#endif
