#include "judge/mine/problem.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "judge/mine/truth.hpp"
#include "objects/objects.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::judge::mine {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Turning about the given body axes' directions in the world, which are the principal ones.
RigidBodyState<> spinning(const RigidBody<>& body, const Vec3& omega) {
  const PrincipalAxes axes = principal_axes(body.I_body());
  const Quat q = from_matrix(axes.R).conjugate();
  return state_of_motion<double>(body, Vec3::Zero(), q, Vec3::Zero(), omega);
}

struct Plan {
  std::string name, title, sentence;
  const objects::Object& object;
  Vec3 omega;  ///< about the principal axes, the least moment first [rad/s]
  double duration;
  std::optional<Pull> pull;
  Model model;
};

Problem made(const Plan& plan) {
  constexpr int resolution = 2;  // a thousand faces and more
  const PolygonMesh mesh = plan.object.mesh(resolution);
  const MassProperties exact = unchecked_mass_properties(mesh, plan.object.density);
  const RigidBody<> body(exact);
  Problem problem{plan.name,           plan.title, plan.sentence, mesh,
                  plan.object.density, exact,      body,          spinning(body, plan.omega),
                  plan.duration,       plan.pull,  plan.model,    Quat::Identity()};
  problem.end = true_end(problem);
  return problem;
}

}  // namespace

double Problem::error(const Numbers& y) const {
  const Quat q(y[3], y[4], y[5], y[6]);
  if (!y.allFinite() || q.squaredNorm() == 0) return std::numeric_limits<double>::quiet_NaN();
  return angle_between(rotation::normalize(q), end);
}

double Problem::energy(const Numbers& y, const MassProperties& properties) const {
  const RigidBodyState<> state = unpack<double>(y);
  const RigidBody<> measured(properties);
  double sum = kinetic_energy(measured, state);
  if (!pull) return sum;
  const Vec3 p = point_position(tumble::derived(measured, state), pull->spring.p_body);
  sum -= measured.mass() * pull->gravity.dot(state.x);
  return sum + pull->spring.stiffness * (pull->spring.anchor - p).squaredNorm() / 2;
}

std::vector<Problem> problems() {
  const objects::Object &handle = objects::all[0], &gear = objects::all[4];
  const Vec3 nearly_middle = turn * Vec3(0.01, 1, -0.01);
  const Pull pull{{0, 0, -9.80665}, {{0, 0.005, 0}, {0, 0, 0.3}, 4, 0}};
  return {made({"free",
                "T-handle, free",
                "a T-handle that nothing pushes, spun about its middle axis",
                handle,
                nearly_middle,
                3,
                {},
                Model::full_body}),
          made({"spring", "T-handle on a spring",
                "the same T-handle, hung from a spring beside its centre", handle, nearly_middle, 2,
                pull, Model::full_body}),
          made({"top",
                "gear, free",
                "a gear that nothing pushes: two of its moments are equal",
                gear,
                turn * Vec3(0.6, 0, 2),
                3,
                {},
                Model::symmetric_top})};
}

}  // namespace tumble::judge::mine
