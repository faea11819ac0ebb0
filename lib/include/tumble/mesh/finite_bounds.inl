#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/finite_bounds.hpp"

namespace tumble::detail {

TUMBLE_BODY FiniteBounds finite_bounds(const PolygonMesh& mesh, simd::InstructionSet instructions) {
  FiniteBounds result;
  dispatch(instructions, VertexBounds{mesh, result});
  return result;
}

}  // namespace tumble::detail
