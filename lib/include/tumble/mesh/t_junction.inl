#pragma once

#include "tumble/mesh/t_junction.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/mesh_defect.hpp"

namespace tumble::detail {

TUMBLE_BODY bool lies_in_middle(const PolygonMesh& mesh, const EdgeUse& edge, int vertex) {
  constexpr double rounding = 1e-6;  // of the length: more than single precision needs
  const Vec3& a = mesh.vertex(edge.low);
  const Vec3 along = mesh.vertex(edge.high) - a, p = mesh.vertex(vertex) - a;
  const double t = p.dot(along) / along.squaredNorm();
  return t > rounding && t < 1 - rounding && (p - t * along).norm() <= rounding * along.norm();
}

TUMBLE_BODY std::optional<TJunction> t_junction_at(const PolygonMesh& mesh, const EdgeUse& edge,
                                                   std::span<const EdgeUse> open) {
  for (const EdgeUse& other : open) {
    for (const int v : {other.low, other.high})
      if (lies_in_middle(mesh, edge, v)) return TJunction{v, edge};
    for (const int v : {edge.low, edge.high})
      if (lies_in_middle(mesh, other, v)) return TJunction{v, other};
  }
  return {};
}

TUMBLE_BODY std::string describe_t_junction(const PolygonMesh& mesh, const EdgeUse& edge,
                                            std::span<const EdgeUse> open) {
  const std::optional<TJunction> junction = t_junction_at(mesh, edge, open);
  if (!junction) return "";
  const EdgeUse& cut = junction->edge;
  return "; " + describe_vertex(mesh, junction->vertex) + " lies in the middle of " +
         (cut.same_edge(edge) ? "this edge" : describe_edge(mesh, cut)) + ", and face #" +
         std::to_string(cut.face + 1) +
         " has no corner there (a T-junction): give it one, or divide it there";
}

}  // namespace tumble::detail
