#pragma once
/// @file
/// What can cross the pipe between judge and worker.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "not_implemented.hpp"

namespace crossing {

/// A bit of everything that a contract can ask for.
struct Luggage {
  double number;
  int count;
  bool fragile;
  std::string label;
  Eigen::Matrix<double, 2, 3> matrix;
  std::vector<Eigen::Vector3d> points;
};

/// A right-hand side: t and y to ẏ.
using Rhs = std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& y)>;

// == 1.1 carry: luggage comes back as it went
/// @return the same, bit for bit
Luggage carry(const Luggage& luggage);

// == 1.2 twice: a function applied twice
/// @param f evaluated exactly twice
/// @return f(t + h, f(t, y))
Eigen::VectorXd twice(const Rhs& f, double t, const Eigen::VectorXd& y, double h);

}  // namespace crossing
