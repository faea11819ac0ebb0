#pragma once
/// @file
/// The box around all vertices, and whether they are numbers at all, in one fast pass.

#include <limits>

#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/simd/instruction_set.hpp"

namespace tumble::detail {

/// What finite_bounds() finds.
struct FiniteBounds {
  Eigen::AlignedBox3d box;  ///< around all vertices [m]; without a meaning unless `finite`
  bool finite = true;       ///< no coordinate is NaN or infinite
};

/// Goes over the vertices, four at a time.
struct VertexBounds {
  const PolygonMesh& mesh;
  FiniteBounds& result;

  template <class P, simd::Fma>
  TUMBLE_INLINE void run() const {
    const std::size_t fours = mesh.vertices.size() / 4;
    // 3 packs of 4 doubles hold 4 vertices: x y z x | y z x y | z x y z
    simd::FourDoubles low[3], high[3], invalid{};
    const double infinity = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      low[k] = simd::FourDoubles{} + infinity;
      high[k] = -low[k];
    }
    const double* at = fours > 0 ? mesh.vertices.front().data() : nullptr;
    for (std::size_t i = 0; i < fours; ++i, at += 12) {
      for (int k = 0; k < 3; ++k) {
        const simd::FourDoubles x = simd::load_four(at + 4 * k);
        low[k] = simd::smaller(x, low[k]);
        high[k] = simd::larger(x, high[k]);
        invalid += x - x;  // 0 for a finite x, NaN otherwise
      }
    }
    for (int i = 0; i < 12; ++i) {
      result.box.min()[i % 3] = std::min(result.box.min()[i % 3], low[i / 4][i % 4]);
      result.box.max()[i % 3] = std::max(result.box.max()[i % 3], high[i / 4][i % 4]);
    }
    for (std::size_t i = 4 * fours; i < mesh.vertices.size(); ++i) {
      result.box.extend(mesh.vertices[i]);
      invalid += (mesh.vertices[i] - mesh.vertices[i]).sum();
    }
    result.finite = simd::sum_of_lanes(invalid) == 0;
  }
};

/// The box around all vertices, used or not, and whether all are finite.
FiniteBounds finite_bounds(const PolygonMesh& mesh,
                           simd::InstructionSet instructions = simd::best_instruction_set());

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/finite_bounds.inl"
#endif
