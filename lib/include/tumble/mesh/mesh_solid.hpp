#pragma once
/// @file
/// The inside of a closed mesh: a point is inside when the surface winds round it (windings.hpp).

#include <memory>
#include <utility>

#include "tumble/core/solid.hpp"
#include "tumble/mesh/closed_surface.hpp"
#include "tumble/mesh/windings.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

/// The body inside a closed mesh, a Solid. Where parts overlap it is their union; parts that are
/// inside out count like others; diagnose() tells of both. Copies share the mesh.
class MeshSolid {
 public:
  /// @throws std::invalid_argument for a mesh with an index out of range, a position that is not
  ///         finite, or an open edge: require_body() names them
  explicit MeshSolid(PolygonMesh mesh) : surface_(surface_of(std::move(mesh))) {}

  /// Whether a point [m] is inside. On the surface itself either answer may come.
  bool contains(const Vec3& point) const { return surface_->contains(point); }

  /// How often the surface winds round a point: 1 inside a body, 0 outside.
  int winding(const Vec3& p) const { return surface_->around(p); }

  const Eigen::AlignedBox3d& bounds() const { return surface_->bounds(); }
  const PolygonMesh& mesh() const { return surface_->mesh(); }

 private:
  static std::shared_ptr<const detail::Windings> surface_of(PolygonMesh mesh) {
    detail::require_closed(mesh);
    return std::make_shared<const detail::Windings>(std::move(mesh));
  }

  std::shared_ptr<const detail::Windings> surface_;
};

static_assert(solids::Solid<MeshSolid>);

/// @}

}  // namespace tumble
