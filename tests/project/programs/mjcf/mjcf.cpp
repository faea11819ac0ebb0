// What ./tumble mass --mjcf prints, read back by MuJoCo itself.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>

#include "project/bench/mujoco_model.hpp"
#include "project/harness/command.hpp"
#include "project/harness/temporary_folder.hpp"
#include "tumble/core/types.hpp"

using namespace tumble;

TEST_CASE("mass --mjcf: MuJoCo reads the mass, the centre and the tensor of a tetrahedron") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "tetrahedron.obj";
  std::ofstream(file) << "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const test::CommandResult block = test::run_command(
      std::string(std::getenv("TUMBLE_SCENES")) + " mass " + file.string() + " --density 3 --mjcf");
  REQUIRE(block.status == 0);
  const std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model(
      bench::load("<mujoco><worldbody><body>" + block.output +
                  "<freejoint/></body></worldbody></mujoco>"),
      mj_deleteModel);
  constexpr int body = 1;  // 0 is the world
  CHECK(model->body_mass[body] == doctest::Approx(1).epsilon(1e-15));
  const Eigen::Map<const Vec3> centre(model->body_ipos + 3 * body),
      moments(model->body_inertia + 3 * body);
  CHECK((centre - Vec3(0.5, 0.25, 0.25)).norm() <= 1e-15);
  const double* q = model->body_iquat + 4 * body;
  const Mat3 R = Quat(q[0], q[1], q[2], q[3]).toRotationMatrix();
  // About the corner ∫ x² dm = m a²/10, ∫ x y dm = m a b/20; then to the centre of mass.
  Mat3 I;
  I << 0.2 - 2 / 16.0, 0.025, 0.025,  //
      0.025, 0.5 - 0.25 - 1 / 16.0, 0.0125, 0.025, 0.0125, 0.5 - 0.25 - 1 / 16.0;
  CHECK((R * moments.asDiagonal() * R.transpose() - I).norm() <= 1e-8);  // its axes have no more
}
