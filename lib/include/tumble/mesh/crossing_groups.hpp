#pragma once
/// @file
/// Crossings that lie apart. In an assembly they may be small and far from each other, so each is
/// measured by itself. What two parts have in common lies where their boxes meet: pairs of parts
/// whose common boxes are apart have nothing in common.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/crossing_cells.hpp"
#include "tumble/mesh/crossing_pairs.hpp"

namespace tumble::detail {

/// The places where triangles meet, in groups that lie apart.
class CrossingGroups {
 public:
  CrossingGroups(const PolygonMesh& mesh, const Components& surface,
                 const TriangleMeetings& meetings);

  /// Those where triangles pass through each other, the largest of them first; at last all others
  /// together.
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
/// @param faces   of the mesh: each measurement goes over all of them, some thirty times
/// @param measure measure(k): the WrongVolume of the k-th
template <class Measure>
WrongVolume sum_over_crossings(std::size_t count, int faces, const Measure& measure) {
  const auto most = static_cast<std::size_t>(std::clamp(2e7 / faces, 8., 64.));
  const std::size_t first = std::min(count, most), left = count - first,
                    step = std::max<std::size_t>(1, (left + most - 1) / most);
  WrongVolume all;
  double squares = 0;
  const auto add = [&](const WrongVolume& one, double times) {
    all.volume += times * one.volume;
    squares += times * times * one.uncertainty * one.uncertainty;
    return one.volume;
  };
  for (std::size_t k = 0; k < first; ++k) add(measure(k), 1);
  WrongLengths drawn;
  const std::size_t drawn_count = (left + step - 1 - step / 2) / step;
  const auto number = static_cast<double>(drawn_count);
  for (std::size_t k = first + step / 2; k < count; k += step)
    drawn.add(add(measure(k), static_cast<double>(left) / number));
  if (step > 1) squares += std::pow(drawn.volume(number, static_cast<double>(left)).uncertainty, 2);
  all.uncertainty = std::sqrt(squares);
  return all;
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/crossing_groups.inl"
#endif
