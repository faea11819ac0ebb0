// expect: wrong | named evaluated too often
// inside() is called twice for each cell.
#include "contract.hpp"

namespace point_sampling {

namespace {

/// A point mass for each cell whose middle is inside.
std::vector<PointMass> full_cells(const Inside& inside, const Eigen::Vector3d& low,
                                  const Eigen::Vector3d& cell, int n, double cell_mass) {
  std::vector<PointMass> points;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        // low + ((i + ½) a, (j + ½) b, (k + ½) c), for a cell of a × b × c
        const Eigen::Vector3d middle =
            low + cell.cwiseProduct(Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5));
        if (inside(middle) && inside(middle)) points.push_back({cell_mass, middle});
      }
    }
  }
  return points;
}

}  // namespace

MassProperties sample_mass_properties(const Inside& inside, const Eigen::Vector3d& low,
                                      const Eigen::Vector3d& high, int n, double density) {
  const Eigen::Vector3d cell = (high - low) / n;
  const double cell_mass = density * cell.prod();
  const std::vector<PointMass> points = full_cells(inside, low, cell, n, cell_mass);
  if (points.empty()) return {0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  const Eigen::Vector3d centre = momentum::centre_of_mass(points);
  const double mass = static_cast<double>(points.size()) * cell_mass;
  return {mass, centre, inertia_of_points(points, centre)};
}

}  // namespace point_sampling
