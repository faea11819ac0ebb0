// SUNDIALS: CVODE's Adams methods and two Runge–Kutta pairs of ARKODE, on the plain motion.
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <stdexcept>

#include "project/bench/dynamics/peers/plain_rhs.hpp"

namespace tumble::bench {
namespace {

constexpr long most_steps = 1'000'000;

void require_success(int status) {
  if (status < 0) throw std::runtime_error("SUNDIALS gave up");
}

/// A problem as SUNDIALS sees it: a state that it works in, and a function of a pointer.
template <class Rhs>
struct Setup {
  Rhs motion;
  PlainState start;
  double duration;
  SUNContext context = nullptr;
  N_Vector y = nullptr;

  explicit Setup(const Problem& problem)
      : motion(problem.body(), problem.scene.push),
        start(plain_state(problem.body().start)),
        duration(problem.duration) {
    SUNContext_Create({}, &context);
    y = N_VNew_Serial(7, context);
    N_VEnableFusedOps_Serial(y, SUNTRUE);
    go_to_start();
  }
  Setup(const Setup&) = delete;
  ~Setup() {
    N_VDestroy(y);
    SUNContext_Free(&context);
  }

  void go_to_start() const { std::copy(start.begin(), start.end(), NV_DATA_S(y)); }
  Quat q() const {
    const double* data = NV_DATA_S(y);
    return {data[0], data[1], data[2], data[3]};
  }
  static int rate(double, N_Vector y, N_Vector dydt, void* motion) {
    (*static_cast<const Rhs*>(motion))(NV_DATA_S(y), NV_DATA_S(dydt));
    return 0;
  }
};

template <class Rhs>
class Cvode {
 public:
  Cvode(const Problem& problem, double tolerance) : setup_(problem) {
    memory_ = CVodeCreate(CV_ADAMS, setup_.context);
    CVodeInit(memory_, Setup<Rhs>::rate, 0, setup_.y);
    CVodeSStolerances(memory_, tolerance, tolerance);
    CVodeSetUserData(memory_, &setup_.motion);
    CVodeSetMaxNumSteps(memory_, most_steps);
    solver_ = SUNNonlinSol_FixedPoint(setup_.y, 0, setup_.context);
    CVodeSetNonlinearSolver(memory_, solver_);
  }
  Cvode(const Cvode&) = delete;
  ~Cvode() {
    CVodeFree(&memory_);
    SUNNonlinSolFree(solver_);
  }

  Quat end() {
    setup_.go_to_start();
    CVodeReInit(memory_, 0, setup_.y);
    CVodeSetStopTime(memory_, setup_.duration);
    double t = 0;
    require_success(CVode(memory_, setup_.duration, setup_.y, &t, CV_NORMAL));
    return setup_.q();
  }

 private:
  Setup<Rhs> setup_;
  void* memory_;
  SUNNonlinearSolver solver_;
};

template <class Rhs>
class ErkStep {
 public:
  ErkStep(const Problem& problem, double tolerance, ARKODE_ERKTableID table) : setup_(problem) {
    memory_ = ERKStepCreate(Setup<Rhs>::rate, 0, setup_.y, setup_.context);
    ERKStepSetTableNum(memory_, table);
    ERKStepSStolerances(memory_, tolerance, tolerance);
    ERKStepSetUserData(memory_, &setup_.motion);
    ERKStepSetMaxNumSteps(memory_, most_steps);
  }
  ErkStep(const ErkStep&) = delete;
  ~ErkStep() { ERKStepFree(&memory_); }

  Quat end() {
    setup_.go_to_start();
    ERKStepReInit(memory_, Setup<Rhs>::rate, 0, setup_.y);
    ERKStepSetStopTime(memory_, setup_.duration);
    double t = 0;
    require_success(ERKStepEvolve(memory_, setup_.duration, setup_.y, &t, ARK_NORMAL));
    return setup_.q();
  }

 private:
  Setup<Rhs> setup_;
  void* memory_;
};

Method adams() {
  const auto prepare = [](const Problem& problem, double tolerance) {
    return with_plain_rhs(problem.scene, [&]<class Rhs>() -> Run {
      return [solver = std::make_shared<Cvode<Rhs>>(problem, tolerance)] { return solver->end(); };
    });
  };
  return {"SUNDIALS", "CVODE Adams", Knob::tolerance, prepare};
}

Method runge_kutta(const std::string& name, ARKODE_ERKTableID table) {
  const auto prepare = [table](const Problem& problem, double tolerance) {
    return with_plain_rhs(problem.scene, [&]<class Rhs>() -> Run {
      return [solver = std::make_shared<ErkStep<Rhs>>(problem, tolerance, table)] {
        return solver->end();
      };
    });
  };
  return {"SUNDIALS", name, Knob::tolerance, prepare};
}

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(tumble::bench::Contestants& contestants) {
  using namespace tumble::bench;
  contestants.methods.push_back(adams());
  contestants.methods.push_back(runge_kutta("ERKStep Fehlberg 8(7)", ARKODE_FEHLBERG_13_7_8));
  contestants.methods.push_back(
      runge_kutta("ERKStep Dormand–Prince 5(4)", ARKODE_DORMAND_PRINCE_7_4_5));
}
