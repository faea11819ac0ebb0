/// @file
/// An engine that is made of a student's functions and of nothing else: from the mesh to the
/// motion. It runs in the student's process, so nothing that it says is believed but the numbers,
/// and those are measured elsewhere.
#include "08_mirtich/contract.hpp"
#include "10_only_what_a_scene_needs/contract.hpp"
#include "judge/mine/student/engine_run.hpp"
#include "judge/worker/serve.hpp"

namespace {

using namespace tumble::judge;
using namespace tumble::judge::mine;
using Eigen::Vector3d;
using rigid_body::State;

mirtich::MassProperties mass(const mirtich::Polyhedron& mesh, double density, int repeats) {
  mirtich::MassProperties result{};
  for (int i = 0; i < repeats; ++i) result = mirtich::mass_properties(mesh, density);
  return result;
}

Eigen::Vector4d top(double A, double C, const Eigen::Vector4d& q0, const Vector3d& L, double t,
                    int repeats) {
  Eigen::Vector4d q = q0;
  for (int i = 0; i < repeats; ++i) q = only_what_a_scene_needs::free_symmetric_top(A, C, q0, L, t);
  return q;
}

only_what_a_scene_needs::EnergyDrift drift(const Setting& setting,
                                           const std::vector<Numbers>& states, double h) {
  std::vector<State> unpacked;
  for (const Numbers& y : states) unpacked.push_back(rigid_body::unpack(y));
  return only_what_a_scene_needs::energy_drift(
      {setting.mass, setting.inertia, setting.inertia.inverse()}, unpacked, h);
}

template <class Result, class... Arguments>
Value answered(Result (*function)(Arguments...), const List& arguments) {
  return answer_with(function, arguments, std::index_sequence_for<Arguments...>{});
}

Value answer(const List& question) {
  const List arguments(question.begin() + 1, question.end());
  switch (from_value<Topic>(question.at(0))) {
    case Topic::mass:
      return answered(mass, arguments);
    case Topic::run:
      return answered(run, arguments);
    case Topic::top:
      return answered(top, arguments);
    case Topic::choose:
      return answered(only_what_a_scene_needs::choose_model, arguments);
    case Topic::drift:
      return answered(drift, arguments);
  }
  throw Malformed("the judge asked for something that there is not");
}

}  // namespace

int main() { return serve_questions(answer); }
