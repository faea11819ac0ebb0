#pragma once
/// @file
/// What an engine is tried on: bodies that the book has met, each with its true orientation at the
/// end, and what the library's methods make of it.

#include <optional>
#include <string>
#include <vector>

#include "judge/mine/questions.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/body/model.hpp"
#include "tumble/mass/mass_properties.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::judge::mine {

/// One run: what it cost and how wrong it was.
struct Point {
  int steps = 0;        ///< 0 for a closed form
  int evaluations = 0;  ///< of dydt
  double seconds = 0;
  double error = 0;  ///< of the orientation at the end [rad]
};

struct Curve {
  std::string name;
  bool own = false;  ///< the student's
  std::vector<Point> points;
};

/// A weight and a spring without a length of its own.
struct Pull {
  Vec3 gravity;
  SpringToWorld spring;
};

struct Problem {
  std::string name;      ///< "free", for JSON
  std::string title;     ///< "T-handle, free"
  std::string sentence;  ///< what moves, and how
  PolygonMesh mesh;
  double density;        ///< [kg/m³]
  MassProperties exact;  ///< each number the true one, rounded
  RigidBody<> body;
  RigidBodyState<> start;
  double duration;  ///< [s]
  std::optional<Pull> pull;
  Model model;  ///< the least that is exact
  Quat end;     ///< the truth, to rounding

  /// [rad]; of any y but zeros, not finite for one that is not
  double error(const Numbers& y) const;
  /// Kinetic energy and that of weight and spring [J], for a body with these properties.
  double energy(const Numbers& y, const MassProperties& properties) const;
  double omega() const { return derived(body, start).omega.norm(); }
};

/// A T-handle in free flight and on a spring, spun about its middle axis; and a gear that nothing
/// pushes.
std::vector<Problem> problems();

/// The same steps as the student's: what a right method is off by.
Point library_run(const Problem& problem, Method method, int steps);

/// RK4, Dormand–Prince 8(5,3), and simulate(): a closed form where nothing pushes.
std::vector<Curve> library_curves(const Problem& problem);

}  // namespace tumble::judge::mine
