#include "tumble/contact/impact.hpp"
#include "tumble/contact/friction_cone.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/sanitized.hpp"
#include "tumble/contact/contact_matrix.hpp"
#include "tumble/contact/friction_impulse.hpp"
#include "tumble/simd/double_double.hpp"

using namespace tumble;
using namespace tumble::contact;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// A body of a kind that turns with all moments between 1 : 1 : 1 and a thin rod.
RigidBody<> any_body(test::Random& rng) {
  const Vec3 a(rng.uniform(0.1, 1), rng.uniform(0.1, 1), rng.uniform(0.1, 1));
  const double mass = std::pow(10, rng.uniform(-1, 1));
  const Vec3 squares = a.cwiseAbs2();
  const Vec3 moments = mass / 3 * (Vec3::Constant(squares.sum()) - squares);
  return {mass, Mat3(moments.asDiagonal())};
}

RigidBodyState<> any_state(test::Random& rng, const RigidBody<>& body) {
  return state_of_motion<double>(body, rng.vector(), rng.rotation(), rng.vector(), rng.vector());
}

Vec3 velocity_at(const RigidBody<>& body, const RigidBodyState<>& state, const Vec3& point) {
  const Derived<> now = derived(body, state);
  return now.v + now.omega.cross(point - now.x);
}

/// The energy that an impulse brings [J]. Long doubles would have too few digits.
double exact_energy(const Impact& impact, const Vec3& impulse) {
  using T = simd::DoubleDouble;
  T sum = 0;
  for (int i = 0; i < 3; ++i) {
    T velocity = impact.u[i];
    for (int k = 0; k < 3; ++k) velocity += T(impact.K(i, k)) * (impulse[k] / 2);
    sum += velocity * impulse[i];
  }
  return double(sum);
}

/// Two bodies that come together at a point.
struct Pair {
  RigidBody<> a, b;
  RigidBodyState<> state_a, state_b;
  Vec3 point;
  Impact impact;

  explicit Pair(test::Random& rng)
      : a(any_body(rng)),
        b(any_body(rng)),
        state_a(any_state(rng, a)),
        state_b(any_state(rng, b)),
        point((state_a.x + state_b.x) / 2 + 0.3 * rng.vector()) {
    const Mat3 K = contact_matrix(a, derived(a, state_a), point) +
                   contact_matrix(b, derived(b, state_b), point);
    const Vec3 u = velocity_at(a, state_a, point) - velocity_at(b, state_b, point);
    Vec3 normal = rng.direction();
    if (u.dot(normal) > 0) normal = -normal;
    impact = {K, u, normal, rng.uniform(0, 1), rng.uniform(0, 1.5)};
  }
  /// ½ u K⁻¹ u: all the energy that an impulse at the point could take.
  double energy() const { return impact.u.dot(impact.K.inverse() * impact.u) / 2; }
};

}  // namespace

TEST_CASE("contact_matrix: its columns are what unit impulses do to the velocity") {
  test::Random rng(901);
  for (int i = 0; i < 200; ++i) {
    const RigidBody<> body = any_body(rng);
    const RigidBodyState<> state = any_state(rng, body);
    const Vec3 point = state.x + rng.vector();
    const Mat3 K = contact_matrix(body, derived(body, state), point);
    for (int k = 0; k < 3; ++k) {
      const RigidBodyState<> after = after_impulse(state, Vec3::Unit(k), point);
      const Vec3 change = velocity_at(body, after, point) - velocity_at(body, state, point);
      CHECK((change - K.col(k)).norm() < 100 * eps * (1 + K.norm()));
    }
    CHECK(K == K.transpose());
    CHECK(K.ldlt().isPositive());
  }
}

TEST_CASE("collide: Newton's law, the energy it costs, and momenta of both bodies") {
  test::Random rng(902);
  for (int i = 0; i < 500; ++i) {
    Pair pair(rng);
    const Impact& impact = pair.impact;
    const ImpactResult result = contact::collide(impact);
    const double u_n = impact.u.dot(impact.normal);
    CHECK(result.u.dot(impact.normal) == doctest::Approx(-impact.e * u_n).epsilon(1e-12));
    // −½ (1 − e²) u_n² / (n·K n)
    const double cost =
        (impact.e * impact.e - 1) * u_n * u_n / (2 * impact.normal.dot(impact.K * impact.normal));
    CHECK(std::abs(result.energy - cost) < 1e-13 * pair.energy());
    const RigidBodyState<> a = after_impulse(pair.state_a, result.impulse, pair.point);
    const RigidBodyState<> b = after_impulse(pair.state_b, -result.impulse, pair.point);
    const Vec3 u = velocity_at(pair.a, a, pair.point) - velocity_at(pair.b, b, pair.point);
    CHECK((u - result.u).norm() < 1e-12 * (1 + u.norm()));
    const auto energy = [&](const RigidBodyState<>& s, const RigidBodyState<>& t) {
      return kinetic_energy(pair.a, s) + kinetic_energy(pair.b, t);
    };
    CHECK(energy(a, b) - energy(pair.state_a, pair.state_b) ==
          doctest::Approx(result.energy).epsilon(1e-9));
  }
}

TEST_CASE("collide_with_friction: never more energy, friction within its cone, bodies part") {
  test::Random rng(903);
  constexpr int count = test::tries(20000);
  int kinds[4] = {};
  for (int i = 0; i < count; ++i) {
    const Pair pair(rng);
    const Impact& impact = pair.impact;
    const ImpactResult result = collide_with_friction(impact);
    const double j_n = result.impulse.dot(impact.normal);
    const double j_t = (result.impulse - j_n * impact.normal).norm();
    CHECK(result.energy < 1e-13 * pair.energy());
    CHECK(j_t < impact.mu * j_n + 1e-9 * result.impulse.norm());
    CHECK(j_n > 0);
    CHECK(result.u.dot(impact.normal) > -1e-9 * impact.u.norm());
    ++kinds[static_cast<int>(result.slip)];
  }
  CHECK(kinds[static_cast<int>(Slip::none)] == 0);
  for (const Slip slip : {Slip::kept, Slip::stuck, Slip::turned})
    CHECK(600 * kinds[static_cast<int>(slip)] > count);
}

TEST_CASE("collide_with_friction: where friction nearly holds, rounding creates no energy either") {
  struct Case {
    double K[6];  // below the diagonal and on it, row by row
    Vec3 u;
    double mu;
  };
  // They gained 8e-7 and 4e-10 of the energy, as K is nearly singular and the impulse large.
  const Case cases[] = {{{0.70337481754486886, 0.43898717946444893, 0.27399211377399307,
                          -0.12619892297548044, -0.07876435051842938, 0.022643277579773861},
                         {-5.1583919977326179e-17, 0, -1.0000000000000002},
                         0.15997828833260289},
                        {{0.58895422057022351, 0.32735641829093876, 0.36376118413062575,
                          0.12671575949882408, -0.064280990064215254, 0.51585697535447017},
                         {-7.5267431255537744e-10, 1.0952598738778438e-09, -1},
                         0.97064814367604024}};
  for (const auto& [k, u, mu] : cases) {
    Mat3 K;
    K << k[0], k[1], k[3], k[1], k[2], k[4], k[3], k[4], k[5];
    const ImpactResult result = collide_with_friction({K, u, Vec3::UnitZ(), 1, mu});
    CHECK(result.energy <= 1e-10 * u.dot(K.inverse() * u) / 2);
    CHECK(result.u.z() > 0.999);
    CHECK(result.impulse.head<2>().norm() <= mu * result.impulse.z() * (1 + 1e-9));
  }
}

TEST_CASE(
    "collide_with_friction: where the slip hardly moves, and friction nearly holds, it ends") {
  struct Case {
    double K[6];  // below the diagonal and on it, row by row
    Vec3 u;
    double mu, e;
  };
  // K_tt is nearly singular. Steps of the curve were as long as the slip, without end.
  const Case cases[] = {{{0.029036841516320674, -0.083889318280047753, 0.26950673607619835,
                          -0.13635390050681346, 0.4336049007287906, 0.70656701972069624},
                         {-2.457880274408306e-09, 2.8924886713799468e-08, -0.99999999999999956},
                         1.5363192056119386,
                         0},
                        {{0.0090724488837672767, 0.043081674513582288, 0.20458158290362469,
                          -0.084463182315632365, -0.40108826639903256, 0.78634620367264429},
                         {3.574891058463091e-09, -4.8658711919499596e-10, -1},
                         2.7071611669636009,
                         1},
                        {{0.28521341147743784, 0.38461791064909678, 0.51942994529362607,
                          -0.23621858810611027, -0.31866974865744352, 0.19566478300661136},
                         {-3.3392462604102716e-09, 3.8094225947154002e-10, -1},
                         0.63206791100754178,
                         0}};
  for (const auto& [k, u, mu, e] : cases) {
    Mat3 K;
    K << k[0], k[1], k[3], k[1], k[2], k[4], k[3], k[4], k[5];
    const ImpactResult result = collide_with_friction({K, u, Vec3::UnitZ(), e, mu});
    CHECK(result.energy <= 0);
    CHECK((result.u - u - K * result.impulse).norm() < 64 * eps * K.norm() * result.impulse.norm());
    CHECK(result.u.z() > -1e-10);
    CHECK(result.impulse.head<2>().norm() <= mu * result.impulse.z() * (1 + 1e-9));
  }
}

TEST_CASE("collide_with_friction: random impacts with friction near holding all end") {
  test::Random rng(905);
  for (int i = 0; i < test::tries(2000); ++i) {
    Impact impact = Pair(rng).impact;
    // Thin bodies: one direction along the surface is hardly moved.
    const double thin = std::pow(10, rng.uniform(-8, 0));
    if (i % 2) impact.e = 1;
    const Mat3 axes = contact::detail::contact_axes(impact.normal),
               R = rng.rotation().toRotationMatrix();
    impact.K = R * Vec3(1, thin, std::pow(10, rng.uniform(-6, 0))).asDiagonal() * R.transpose();
    impact.K = (impact.K + impact.K.transpose()).eval() / 2;
    const double slip = std::pow(10, rng.uniform(-10, 0));
    impact.u = axes * Vec3(slip * rng.uniform(-1, 1), slip * rng.uniform(-1, 1), -1);
    const double holding =
        contact::detail::holding_friction(axes.transpose() * impact.K * axes).norm();
    impact.mu = holding * (1 + rng.uniform(-1, 1) * std::pow(10, rng.uniform(-15, -2)));
    const ImpactResult result = collide_with_friction(impact);
    const double along = result.impulse.dot(impact.normal);
    const double size = impact.u.norm() * result.impulse.norm();
    CHECK(exact_energy(impact, result.impulse) <= 64 * eps * size);
    CHECK((result.impulse - along * impact.normal).norm() <= impact.mu * along * (1 + 1e-9));
    CHECK(result.u.dot(impact.normal) > -1e-10);
  }
}

TEST_CASE("collide_with_friction: without friction Newton's law, and alike in all directions") {
  test::Random rng(904);
  for (int i = 0; i < 200; ++i) {
    Impact impact = Pair(rng).impact;
    impact.mu = 0;
    CHECK((collide_with_friction(impact).impulse - contact::collide(impact).impulse).norm() == 0);
    impact.mu = 1e-14;
    CHECK((collide_with_friction(impact).impulse - contact::collide(impact).impulse).norm() <
          1e-11 * contact::collide(impact).impulse.norm());
    impact.mu = 0.7;
    const ImpactResult result = collide_with_friction(impact);
    const Mat3 R = rng.rotation().toRotationMatrix();
    const Impact turned{R * impact.K * R.transpose(), R * impact.u, R * impact.normal, impact.e,
                        impact.mu};
    CHECK((collide_with_friction(turned).impulse - R * result.impulse).norm() <
          1e-9 * result.impulse.norm());
  }
}

TEST_CASE("collide_with_friction: a ball with slip rolls off with 5/7 of its speed") {
  const double m = 0.2, r = 0.03;
  const RigidBody<> ball(m, Mat3(Mat3::Identity() * (0.4 * m * r * r)));
  RigidBodyState<> state =
      state_of_motion<double>(ball, Vec3(0, 0, r), Quat(1, 0, 0, 0), Vec3(3, 0, -20), Vec3::Zero());
  const Mat3 K = contact_matrix(ball, derived(ball, state), Vec3::Zero());
  const ImpactResult result =
      collide_with_friction({K, velocity_at(ball, state, Vec3::Zero()), Vec3::UnitZ(), 0.5, 0.4});
  CHECK(result.slip == Slip::stuck);
  state = after_impulse(state, result.impulse, Vec3::Zero());
  const Derived<> now = derived(ball, state);
  CHECK(now.v.x() == doctest::Approx(3 * 5. / 7).epsilon(1e-13));
  CHECK(now.omega.y() == doctest::Approx(now.v.x() / r).epsilon(1e-13));
  CHECK(now.v.z() == doctest::Approx(10).epsilon(1e-13));
}

TEST_CASE(
    "collide_with_friction: the rod whose slip turns round, where the usual law creates energy") {
  // A thin rod of length 2 and mass 1, 30° to the floor; slip 0.2, coming down with 1.
  const RigidBody<> rod(1, Mat3(Vec3(1e-3, 1. / 3, 1. / 3).asDiagonal()));
  const Quat q(Eigen::AngleAxisd(std::acos(-1.0) / 6, Vec3::UnitY()));
  const Vec3 tip = q * Vec3(1, 0, 0);
  const Derived<> now{-tip, q.toRotationMatrix(), Vec3::Zero(), Vec3::Zero()};
  const Impact impact{contact_matrix(rod, now, Vec3::Zero()), Vec3(-0.2, 0, -1), Vec3::UnitZ(), 0.9,
                      0.5};
  // The usual law: friction against the slip as it was, and u'·n = −e u·n.
  const Vec3 press(0.5, 0, 1);
  const Vec3 usual = -1.9 * impact.u.z() / (impact.K * press).z() * press;
  const double energy = impact.u.dot(impact.K.inverse() * impact.u) / 2;
  const double created = energy_of(impact.u, impact.u + impact.K * usual, usual);
  CHECK(created / energy == doctest::Approx(0.329).epsilon(1e-3));
  const ImpactResult result = collide_with_friction(impact);
  CHECK(result.slip == Slip::turned);
  CHECK(result.u.x() > 0);
  CHECK(result.energy / energy < -0.3);
}

TEST_CASE("collide_with_friction: a slender rod that jams is said to, and parts all the same") {
  // μ > 4/3 for a thin rod: friction of its slip presses it into the floor (Painlevé).
  const RigidBody<> rod(1, Mat3(Vec3(1e-4, 1. / 3, 1. / 3).asDiagonal()));
  for (const double mu : {1.2, 1.5, 3.}) {
    bool jammed = false;
    for (double angle = 0.6; angle < 1.5; angle += 0.02) {
      const Quat q(Eigen::AngleAxisd(angle, Vec3::UnitY()));
      const Vec3 tip = q * Vec3(1, 0, 0);
      const Derived<> now{-tip, q.toRotationMatrix(), Vec3::Zero(), Vec3::Zero()};
      const Mat3 K = contact_matrix(rod, now, Vec3::Zero());
      for (const double slip : {-1., 1.}) {
        const ImpactResult result =
            collide_with_friction({K, Vec3(slip, 0, -0.1), Vec3::UnitZ(), 0.5, mu});
        jammed = jammed || result.jammed;
        CHECK(result.u.allFinite());
        CHECK(result.u.z() >= 0);
        CHECK(result.energy < 0);
      }
    }
    CHECK(jammed == (mu > 4. / 3));
  }
}

TEST_CASE("impacts that are none are refused") {
  const Impact good{Mat3::Identity(), Vec3(0, 0, -1), Vec3::UnitZ(), 0.5, 0.5};
  const auto with = [&](auto change) {
    Impact bad = good;
    change(bad);
    return bad;
  };
  CHECK_REFUSED(contact::collide(with([](Impact& i) { i.e = 1.1; })), "restitution");
  CHECK_REFUSED(contact::collide(with([](Impact& i) { i.e = NAN; })), "restitution");
  CHECK_REFUSED(contact::collide(with([](Impact& i) { i.mu = -0.1; })), "friction");
  CHECK_REFUSED(contact::collide(with([](Impact& i) { i.normal = Vec3::Zero(); })), "normal");
  CHECK_REFUSED(contact::collide(with([](Impact& i) { i.K.setZero(); })), "infinite mass");
  CHECK_REFUSED(collide_with_friction(with([](Impact& i) { i.u.x() = NAN; })), "not finite");
  CHECK(collide_with_friction(with([](Impact& i) { i.u.z() = 1; })).impulse.isZero(0));
}
