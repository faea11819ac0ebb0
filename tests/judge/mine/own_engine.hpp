#pragma once
/// @file
/// The student's engine as the judge asks it: typed questions, each with a clock on the judge's
/// side of the pipe.

#include <string>
#include <vector>

#include "08_mirtich/contract.hpp"
#include "10_only_what_a_scene_needs/contract.hpp"
#include "judge/conversation/student_worker.hpp"
#include "judge/mine/questions.hpp"

namespace tumble::judge::mine {

/// An answer, and how long it took to work out [s].
template <class T>
struct Timed {
  T answer;
  double seconds = 0;
};

/// Every question is put to a fresh process behind all walls. All throw NoAnswer, also where an
/// answer has the wrong shape.
class OwnEngine {
 public:
  explicit OwnEngine(WorkerProgram program) : program_(std::move(program)) {}

  Timed<mirtich::MassProperties> mass(const mirtich::Polyhedron& mesh, double density) const;
  /// @param question its `repeats` are chosen here, for the clock
  Timed<RunAnswer> run(RunQuestion question) const;
  Timed<quaternions::Quaternion> top(double A, double C, const quaternions::Quaternion& q0,
                                     const Eigen::Vector3d& L, double t) const;
  only_what_a_scene_needs::Choice choose(const only_what_a_scene_needs::Scene& scene,
                                         double tolerance) const;
  only_what_a_scene_needs::EnergyDrift drift(const Setting& setting,
                                             const std::vector<Numbers>& states, double h) const;

 private:
  WorkerProgram program_;
};

/// The die of a student's functions.
/// @throws NoAnswer also if these are not the states of a motion
DieAnswer drop_die(const WorkerProgram& program, const DieQuestion& question);

}  // namespace tumble::judge::mine
