// MuJoCo: its integrators, on bodies with a free joint each and nothing else in the world.
#include <limits>
#include <sstream>

#include "project/bench/dynamics/contest.hpp"
#include "project/bench/mujoco_model.hpp"

namespace tumble::bench {
namespace {

/// The scene in MuJoCo's own language.
std::string model_of(const Scene& scene, double h, const std::string& integrator) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<mujoco><compiler boundmass=\"0\" boundinertia=\"0\"/><option timestep=\"" << h
      << "\" integrator=\"" << integrator
      << "\" gravity=\"0 0 0\"><flag constraint=\"disable\" "
         "contact=\"disable\"/></option><worldbody>";
  for (const Body& body : scene.bodies)
    xml << "<body><freejoint/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"" << body.moments[0]
        << ' ' << body.moments[1] << ' ' << body.moments[2] << "\"/></body>";
  xml << "</worldbody></mujoco>";
  return xml.str();
}

class World : public Simulation {
 public:
  World(const Scene& scene, double h, const std::string& integrator)
      : scene_(scene), model_(load(model_of(scene, h, integrator))), data_(mj_makeData(model_)) {}
  World(const World&) = delete;
  ~World() override {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }

  void restart() override {
    mj_resetData(model_, data_);
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      const auto& [q, omega] = scene_.bodies[i].start;
      const double qpos[4] = {q.w(), q.x(), q.y(), q.z()};
      std::copy_n(qpos, 4, data_->qpos + 7 * i + 3);  // behind the position
      std::copy_n(omega.data(), 3, data_->qvel + 6 * i + 3);
    }
  }
  void advance(int steps) override {
    pushed_ = scene_.free() ? nullptr : &scene_.push;
    mjcb_control = apply_torque;
    for (int i = 0; i < steps; ++i) mj_step(model_, data_);
    mjcb_control = nullptr;
  }
  Spin spin(std::size_t body) const override {
    // A state that is no number has been put back to the model's own, with a warning.
    for (const mjtWarning bad : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
      if (data_->warning[bad].number > 0) return {Quat(nan, nan, nan, nan), Vec3(nan, nan, nan)};
    const mjtNum* q = data_->qpos + 7 * body + 3;
    const mjtNum* omega = data_->qvel + 6 * body + 3;
    return {Quat(q[0], q[1], q[2], q[3]), Vec3(omega[0], omega[1], omega[2])};
  }

 private:
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  /// Called in every stage of a step, not once a step: else RK4 would be of order 1.
  static void apply_torque(const mjModel* model, mjData* data) {
    if (!pushed_) return;
    for (int b = 1; b < model->nbody; ++b) {  // 0 is the world
      mjtNum arm[3], torque[3];
      mju_rotVecMat(arm, pushed_->p_body.data(), data->ximat + 9 * b);
      mju_cross(torque, arm, pushed_->force.data());
      mju_copy3(data->xfrc_applied + 6 * b + 3, torque);
    }
  }

  inline static const Push* pushed_ = nullptr;
  Scene scene_;
  mjModel* model_;
  mjData* data_;
};

/// Many bodies in worlds of a few: its compiler takes time as the square of the bodies of a world.
class Worlds : public Simulation {
 public:
  Worlds(const Scene& scene, double h, const std::string& integrator) {
    for (std::size_t i = 0; i < scene.bodies.size(); i += few) {
      const auto first = scene.bodies.begin() + static_cast<std::ptrdiff_t>(i);
      const std::size_t count = std::min(few, scene.bodies.size() - i);
      const Scene part{{first, first + static_cast<std::ptrdiff_t>(count)}, scene.push};
      worlds_.push_back(std::make_unique<World>(part, h, integrator));
    }
  }

  void restart() override {
    for (const auto& world : worlds_) world->restart();
  }
  void advance(int steps) override {
    for (const auto& world : worlds_) world->advance(steps);
  }
  Spin spin(std::size_t body) const override { return worlds_[body / few]->spin(body % few); }

 private:
  static constexpr std::size_t few = 50;
  std::vector<std::unique_ptr<World>> worlds_;
};

Stepper stepper(const std::string& integrator) {
  const auto make = [integrator](const Scene& scene, double h) -> std::unique_ptr<Simulation> {
    // Each step of it does too: 44 µs a body in a world of 50.
    if (integrator == "implicit" && scene.bodies.size() > 1) return nullptr;
    return std::make_unique<Worlds>(scene, h, integrator);
  };
  return {"MuJoCo", integrator, make};
}

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(tumble::bench::Contestants& contestants) {
  mju_user_warning = [](const char*) {};  // it would write them into a file
  for (const char* integrator : {"Euler", "implicit", "RK4"})
    contestants.steppers.push_back(tumble::bench::stepper(integrator));
}
