#pragma once

#include "tumble/mesh/enclosed_volume.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/sum_over_blocks.hpp"

namespace tumble::detail {

TUMBLE_BODY EnclosedVolume enclosed_by(const PolygonMesh& mesh, const simd::LoopOptions& options) {
  const Vec3 origin = mesh.vertex(mesh.corners[0]);
  const auto add = [&](const TriangleBlock& block, EnclosedVolume& sum) {
    dispatch(options.instructions, BlockVolume{block, origin, sum});
  };
  return sum_over_blocks<EnclosedVolume>(mesh, options, add);
}

TUMBLE_BODY simd::DoubleDouble precise_six_volume(const Vec3& a, const Vec3& b, const Vec3& c,
                                                  const Vec3& o) {
  const auto exact = [](const Vec3& p, const Vec3& q) -> simd::Point<Pair<double>> {
    return {two_diff(p.x(), q.x()), two_diff(p.y(), q.y()), two_diff(p.z(), q.z())};
  };
  return simd::dot(cross(exact(b, a), exact(c, a)), exact(a, o));
}

}  // namespace tumble::detail
