#pragma once
/// @file
/// Adds up what the triangles of a mesh bring, block by block, by several threads.

#include <vector>

#include "tumble/core/parallel.hpp"
#include "tumble/mesh/triangle_blocks.hpp"
#include "tumble/simd/loop_options.hpp"

namespace tumble::detail {

/// The sum over all blocks.
/// @tparam Sum has += and starts as 0
/// @param add  add(block, sum) adds a TriangleBlock
/// @param mesh indices in range
template <class Sum, class Add>
Sum sum_over_blocks(const PolygonMesh& mesh, const simd::LoopOptions& options, const Add& add) {
  constexpr int chunk = 1 << 14;  // faces: some 0.1 ms of work
  const int faces = mesh.face_count(), chunks = (faces + chunk - 1) / chunk;
  std::vector<Sum> sums(static_cast<std::size_t>(chunks));
  parallel_for(chunks, options.threads, [&](int i) {
    Sum sum{};
    TriangleBlocks blocks(mesh, options.instructions);
    blocks.for_each(i * chunk, std::min((i + 1) * chunk, faces),
                    [&](const TriangleBlock& block) { add(block, sum); });
    sums[static_cast<std::size_t>(i)] = std::move(sum);
  });
  Sum total{};
  for (const Sum& sum : sums) total += sum;
  return total;
}

}  // namespace tumble::detail
