// expect: wrong | named everything is inside
// The answer is always yes.
#include "contract.hpp"

namespace point_sampling {

namespace {

/// Seen from above, does the edge from a to b cross the half-line from p towards +x? 1 if it does
/// so towards +y, −1 if towards −y. An edge ends just below a vertex with p's y, so that each
/// vertex belongs to one edge only; and both triangles of an edge get the same number, up to its
/// sign, however it is rounded, since it is always made from the lower end.
int edge_crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p) {
  const bool up = b.y() > p.y();
  if ((a.y() > p.y()) == up) return 0;
  const Eigen::Vector3d& low = up ? a : b;
  const Eigen::Vector3d& high = up ? b : a;
  const double left =
      (high.x() - low.x()) * (p.y() - low.y()) - (high.y() - low.y()) * (p.x() - low.x());
  if (left <= 0) return 0;
  return up ? 1 : -1;
}

/// Does the ray from p upwards meet the triangle? 1 if it leaves the body there, −1 if it enters.
int triangle_crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                      const Eigen::Vector3d& p) {
  const int line_crossing =
      edge_crossing(a, b, p) + edge_crossing(b, c, p) + edge_crossing(c, a, p);
  // 6 times the volume between p and the triangle: (a − p) · ((b − p) × (c − p))
  const double volume = (a - p).dot(rotation_matrices::skew(b - p) * (c - p));
  const bool above = line_crossing * volume > 0;
  return above ? line_crossing : 0;
}

}  // namespace

bool inside_mesh(const Mesh& mesh, const Eigen::Vector3d& point) {
  // How often the surface goes round the point: leaving counts 1, entering −1.
  int winding = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const auto corner = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
    winding += triangle_crossing(corner(i), corner(j), corner(k), point);
  }
  return winding == winding;
}

}  // namespace point_sampling
