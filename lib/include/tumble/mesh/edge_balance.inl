#pragma once

#include "tumble/mesh/edge_balance.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/sum_over_blocks.hpp"

namespace tumble::detail {

TUMBLE_BODY bool is_closed(const PolygonMesh& mesh, const simd::LoopOptions& options) {
  const auto add = [&](const TriangleBlock& block, std::uint64_t& sum) {
    dispatch(options.instructions, BlockBalance{block, sum});
  };
  return sum_over_blocks<std::uint64_t>(mesh, options, add) == 0;
}

}  // namespace tumble::detail
