#pragma once
/// @file
/// What is measured, on which meshes: methods, ours and others', and bodies with a known truth.

#include <functional>
#include <string>
#include <vector>

#include "project/bench/least_times.hpp"
#include "tumble/mass/error_bound.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::bench {

/// A mesh and the truth about it (density 1).
struct Body {
  std::string name;
  PolygonMesh mesh;
  MassProperties truth;
  Vector3<simd::DoubleDouble>
      centre;       ///< the truth beyond what a double holds, for bodies far away
  double diagonal;  ///< of the box along the axes: what errors of the centre are measured by
};

/// What a method says of a body. What it does not compute stays NaN.
struct Answer : MassProperties {
  Vec3 centre_rest = Vec3::Zero();  ///< see BoundedMassProperties
  double mass_error_bound = std::numeric_limits<double>::quiet_NaN();
  double inertia_error_bound = std::numeric_limits<double>::quiet_NaN();

  Answer() = default;
  Answer(const MassProperties& body) : MassProperties(body) {}  // NOLINT: a method's answer
  Answer(const BoundedMassProperties& body)                     // NOLINT
      : MassProperties(body),
        centre_rest(body.centre_rest),
        mass_error_bound(body.mass_error_bound),
        inertia_error_bound(body.inertia_error_bound) {}
};

/// One run, prepared: what is not part of the computation (a copy in another program's format) has
/// been done.
using Run = std::function<Answer()>;

/// A way to get mass properties.
struct Method {
  std::string name;
  std::function<Run(const Body&)> prepare;
  bool slow = false;       ///< left out for a million triangles
  std::string curve = {};  ///< methods with the same are points of one curve in the figure
  bool in_figure = true;
  Clock clock = Clock::thread;  ///< where several threads work, that on the wall
};

/// Methods of other software, where it is installed. Each has a file of its own in peers/.
void add_cgal(std::vector<Method>& methods);
void add_ode(std::vector<Method>& methods);
void add_bullet(std::vector<Method>& methods);
void add_mujoco(std::vector<Method>& methods);
void add_libigl(std::vector<Method>& methods);
void add_volint(std::vector<Method>& methods);

std::vector<Method> own_methods();
std::vector<Method> peers();

/// A mug, a regular cube, Spot (if its file is there), a torus of `triangles`, the same far away, a
/// needle.
std::vector<Body> bodies(int triangles);

}  // namespace tumble::bench
