// MuJoCo: it has no coefficient of restitution. Contacts are springs with dampers; ours are as
// stiff as the step allows, and damped so that a body that hits a wall keeps the part e of its
// speed.
#include <cmath>
#include <sstream>

#include "project/bench/contact/contest.hpp"
#include "project/bench/mujoco_model.hpp"

namespace tumble::bench {
namespace {

/// How much damping lets a spring that never pulls give back e: β/ω₀ of ẍ = −2β ẋ − ω₀² x, by
/// bisection. Source: Schwager & Pöschel, "Coefficient of restitution and linear-dashpot model
/// revisited", Granular Matter 9 (2007).
double damping_for(double e) {
  const auto given_back = [](double b) {
    const double w = std::sqrt(1 - b * b);  // the contact ends where the force is 0
    return std::exp(-b / w * std::atan2(2 * b * w, 2 * b * b - 1));
  };
  double low = 0, high = 0.999;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (given_back(middle) > e ? low : high) = middle;
  }
  return low;
}

class Model {
 public:
  Model(const Scene& scene, double h) {
    text_.precision(17);
    const std::size_t contacts = 16 + 4 * scene.bodies.size();  // what is larger takes long to make
    const double rate = 0.1 / h, damping = 2 * damping_for(scene.e) * rate;
    text_ << "<mujoco><compiler boundmass=\"0\" boundinertia=\"0\"/><size nconmax=\"" << contacts
          << "\" njmax=\"" << 4 * contacts << "\"/><option timestep=\"" << h << "\" gravity=\""
          << scene.gravity.transpose()
          << "\" cone=\"elliptic\" tolerance=\"1e-14\" iterations=\"200\"/><default><geom "
             "solref=\""
          << -rate * rate << ' ' << -damping << "\" solimp=\"0.9999 0.9999 1\" friction=\""
          << scene.mu << " 0 0\" condim=\"" << (scene.mu > 0 ? 3 : 1)
          << "\"/></default><worldbody>";
    for (const Wall& wall : scene.walls)
      text_ << "<geom type=\"plane\" size=\"0 0 1\" pos=\"" << wall.point.transpose()
            << "\" zaxis=\"" << wall.normal.transpose() << "\"/>";
    for (const Body& body : scene.bodies) add(body);
    text_ << "</worldbody></mujoco>";
  }
  std::string text() const { return text_.str(); }

 private:
  void add(const Body& body) {
    const bool round = body.form == Form::ball;
    text_ << "<body><freejoint/><inertial pos=\"0 0 0\" mass=\"" << body.mass << "\" diaginertia=\""
          << body.moments.transpose() << "\"/><geom type=\"" << (round ? "sphere" : "box")
          << "\" size=\"" << Vec3(body.size / 2).transpose() << "\"/></body>";
  }

  std::ostringstream text_;
};

class World {
 public:
  World(const Scene& scene, std::shared_ptr<mjModel> model)
      : model_(std::move(model)), data_(mj_makeData(model_.get())) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const auto& [x, v, q, omega] = scene.bodies[i].start;
      const Vec3 spin = q.conjugate() * omega;
      const double qpos[7] = {x[0], x[1], x[2], q.w(), q.x(), q.y(), q.z()};
      const double qvel[6] = {v[0], v[1], v[2], spin[0], spin[1], spin[2]};
      std::copy_n(qpos, 7, data_->qpos + 7 * i);
      std::copy_n(qvel, 6, data_->qvel + 6 * i);
    }
  }
  World(const World&) = delete;
  ~World() { mj_deleteData(data_); }

  void advance(int steps) {
    for (int i = 0; i < steps; ++i) mj_step(model_.get(), data_);
  }
  Motion motion(std::size_t i) const {
    const mjtNum *p = data_->qpos + 7 * i, *u = data_->qvel + 6 * i;
    const Quat q(p[3], p[4], p[5], p[6]);
    return {Vec3(p[0], p[1], p[2]), Vec3(u[0], u[1], u[2]), q, q * Vec3(u[3], u[4], u[5])};
  }

 private:
  std::shared_ptr<mjModel> model_;
  mjData* data_;
};

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(std::vector<tumble::bench::Stepper>& steppers) {
  using namespace tumble::bench;
  mju_user_warning = [](const char*) {};  // it would write them into a file
  const auto make = [](const Scene& scene, double h) -> std::unique_ptr<Simulation> {
    constexpr std::size_t many = 50;  // its compiler takes time as the square of the bodies
    if (scene.bodies.size() > many) return nullptr;
    const std::shared_ptr<mjModel> model(load(Model(scene, h).text()), mj_deleteModel);
    return std::make_unique<Fresh<World>>(
        [scene, model] { return std::make_unique<World>(scene, model); });
  };
  steppers.push_back({"MuJoCo", "springs, it has no restitution", make});
}
