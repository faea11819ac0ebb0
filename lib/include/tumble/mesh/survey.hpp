#pragma once
/// @file
/// What one pass over the triangles of a mesh tells: whether it is closed, what it encloses, and
/// which triangles lines along the three axes may meet. Each corner is loaded once for all of it.

#include "tumble/mesh/edge_balance.hpp"
#include "tumble/mesh/enclosed_volume.hpp"
#include "tumble/mesh/near_lines.hpp"

namespace tumble::detail {

/// What one pass tells.
struct Survey {
  std::uint64_t balance = 0;  ///< 0: closed, and the faces agree on what is outside
  EnclosedVolume enclosed;
  TrianglesNearLines near_lines;

  Survey& operator+=(const Survey& other) {
    balance += other.balance;
    enclosed += other.enclosed;
    near_lines += other.near_lines;
    return *this;
  }
};

/// Surveys a block.
struct BlockSurvey {
  const TriangleBlock& block;
  const Vec3& origin;
  const LatticeFilters& filters;
  Survey& result;

  template <class P, simd::Fma>
  TUMBLE_INLINE void run() const {
    using L = simd::Integers<P>;
    const simd::Point<P> o{P{} + origin.x(), P{} + origin.y(), P{} + origin.z()};  // in all lanes
    P six_volume{}, magnitude{}, twice_area{}, doubtful{};
    L areas{};
    for (int i = 0; i < block.size; i += simd::lanes<P>) {
      areas += random_areas<P>(block.vertices + 3 * i);
      const int* corners = block.corners + 3 * i;
      const auto a = simd::load_corners<P>(block.coordinates, corners, 0),
                 b = simd::load_corners<P>(block.coordinates, corners, 1),
                 c = simd::load_corners<P>(block.coordinates, corners, 2);
      const VolumeTerms<P> terms(a, b, c, o);
      six_volume += terms.six_volume;
      magnitude += terms.magnitude;
      twice_area += terms.twice_area;
      doubtful += terms.doubtful;
      note_near_lines<P>(block, filters, i, a, b, c, result.near_lines);
    }
    result.balance += sum_of_lanes_modulo<P>(areas);
    result.enclosed +=
        {simd::sum_of_lanes(six_volume), simd::sum_of_lanes(magnitude),
         simd::sum_of_lanes(twice_area), simd::sum_of_lanes(doubtful) - block.padding};
  }
};

/// Goes over all triangles once.
/// @param mesh indices in range, positions finite
Survey survey(const PolygonMesh& mesh, const LatticeFilters& filters,
              const simd::LoopOptions& options);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/survey.inl"
#endif
