/// @file
/// 11.2 separation: its laws, and what goes wrong.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "11_when_bodies_meet/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::Vec3;
using when_bodies_meet::Box, when_bodies_meet::Separation;

namespace student {
const Function<decltype(when_bodies_meet::separation)> separation{TUMBLE_UNIT};
}

namespace {

using Directions = std::vector<Vec3>;

// ── Right and wrong answers, in parts ──

void add_edges(Directions& directions, const Box& a, const Box& b) {
  for (const Box& box : {a, b})
    for (int k = 0; k < 3; ++k) directions.push_back(box.R.col(k));
}

Directions products(const Box& a, const Box& b) {
  Directions all;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) all.push_back(a.R.col(i).cross(b.R.col(j)));
  return all;
}

/// The edges' directions, and those products whose sine is larger.
Directions with_products(const Box& a, const Box& b, double sine) {
  Directions all;
  add_edges(all, a, b);
  for (const Vec3& product : products(a, b))
    if (product.norm() > sine) all.push_back(product.normalized());
  return all;
}

Directions fifteen(const Box& a, const Box& b) { return with_products(a, b, 1e-6); }

/// How far a box reaches from its centre along n.
double half_extent(const Box& box, const Vec3& n) {
  const Vec3 seen = box.R.transpose() * n;
  return 0.5 * box.size.dot(seen.cwiseAbs());
}

/// A reader of the contract, taken apart so that each part can go wrong by itself.
struct Reader {
  Directions (*directions)(const Box& a, const Box& b) = fifteen;
  double (*reach)(const Box& box, const Vec3& n) = half_extent;
  bool (*better)(double gap, double best) = [](double gap, double best) { return gap > best; };
  double (*side)(double along) = [](double along) { return std::copysign(1., along); };

  Separation operator()(const Box& a, const Box& b) const {
    Separation best{0, Vec3::Zero()};
    bool first = true;
    for (const Vec3& n : directions(a, b)) {
      const double along = n.dot(b.centre - a.centre);
      const double gap = std::abs(along) - reach(a, n) - reach(b, n);
      if (first || better(gap, best.gap)) best = {gap, side(along) * n};
      first = false;
    }
    return best;
  }
};

Separation reference(const Box& a, const Box& b) { return Reader{}(a, b); }

/// The right answer, changed afterwards.
template <class Change>
auto changed(Change change) {
  return [change](const Box& a, const Box& b) {
    Separation answer = reference(a, b);
    change(answer, a, b);
    return answer;
  };
}

// ── Laws ──

/// A product has the length of a sine, here 0.01 or more, so its direction is off by 100 eps at
/// most times a few; that moves a gap by as much of the boxes' sizes and distance.
double rounding(const Box& a, const Box& b) {
  return 2000 * eps * (a.size.sum() + b.size.sum() + (b.centre - a.centre).norm());
}

/// The gap of the two boxes between planes with the normal n from a to b.
double gap_along(const Box& a, const Box& b, const Vec3& n) {
  return n.dot(b.centre - a.centre) - half_extent(a, n) - half_extent(b, n);
}

bool is_right(const Box& a, const Box& b) {
  const auto answer = student::separation(a, b);
  const Vec3 n = answer->normal;
  // The columns of R may be off by some roundings, after several turns.
  return answer == obeys("the normal has the length 1", std::abs(n.norm() - 1), 64 * eps) &&
         answer == obeys("all of A is behind one plane, all of B beyond the other, `gap` apart",
                         std::abs(gap_along(a, b, n) - answer->gap), rounding(a, b)) &&
         answer == obeys("no other of the 15 directions has a larger gap",
                         worse(0, reference(a, b).gap - answer->gap), rounding(a, b)) &&
         answer == obeys("a gap along one of the 15 directions: none has so large a gap",
                         worse(0, answer->gap - reference(a, b).gap), rounding(a, b));
}

// ── Boxes ──

Box any_box(double size = 1) {
  return {any_vector(0.5), any_rotation(),
          size * Vec3{any_number(0.5, 2), any_number(0.5, 2), any_number(0.5, 2)}};
}

/// The edges of both are at 0.01 rad or more to one another, or parallel to rounding.
bool is_clear(const Box& a, const Box& b) {
  for (const Vec3& product : products(a, b))
    if (product.norm() < 0.01 && product.norm() > 1e-12) return false;
  return true;
}

/// Two boxes that the gap decides: its size is not that of rounding.
struct Two {
  Box a, b;
};

/// Boxes whose centres are about `distance` apart.
Two any_two(double distance) {
  Two two{any_box(), any_box()};
  while (!is_clear(two.a, two.b)) two.b.R = any_rotation();
  two.b.centre = two.a.centre + distance * any_direction();
  return two;
}

/// Boxes of which an edge of each is nearest to the other: only a product separates them.
Two edge_on_edge(double gap) {
  Two two{any_box(), any_box()};
  const Mat3 world = any_rotation();
  // A's edge along x on top, B's edge along y below, each on a side turned by 45°.
  const Mat3 roof = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()).toRotationMatrix();
  const Mat3 keel = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()).toRotationMatrix();
  two.a.R = world * roof;
  two.b.R = world * keel;
  two.a.size = Vec3(any_number(2, 3), 1, 1);
  two.b.size = Vec3(1, any_number(2, 3), 1);
  two.b.centre = two.a.centre + world * Vec3(0, 0, std::sqrt(2.) + gap);
  return two;
}

/// The same two, all lengths `scale` times as long.
Two scaled(Two two, double scale) {
  for (Box* box : {&two.a, &two.b}) {
    box->centre *= scale;
    box->size *= scale;
  }
  return two;
}

/// Two long rods, edge over edge, that cross at a small angle.
Two crossing_rods(double angle, double gap) {
  const Mat3 world = any_rotation();
  const Mat3 roof = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()).toRotationMatrix();
  const Mat3 aside = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 size(any_number(2, 4) / angle, 1, 1), place = any_vector(1);
  const Vec3 above = place + world * Vec3(0, 0, std::sqrt(2.) + gap);
  return {{place, world * roof, size}, {above, world * aside * roof, size}};
}

Box moved(Box box, const Mat3& turn, const Vec3& shift) {
  box.centre = turn * box.centre + shift;
  box.R = turn * box.R;
  return box;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("two upright cubes of 1 m: 3 m apart along x the gap is 2, in one another −0.25") {
    const Box a{{0, 0, 0}, Mat3::Identity(), {1, 1, 1}};
    Box b = a;
    b.centre.x() = 3;
    REQUIRE(student::separation(a, b) == close_to(Separation{2, Vec3::UnitX()}, 16 * eps));
    REQUIRE(student::separation(b, a) == close_to(Separation{2, -Vec3::UnitX()}, 16 * eps));
    b.centre = {0.25, 0, -0.75};
    REQUIRE(student::separation(a, b) == close_to(Separation{-0.25, -Vec3::UnitZ()}, 16 * eps));
  }

  TEST_CASE("edge over edge: only a product of two edges shows the light between them") {
    // At first an angle at which a product that was not normalised still wins.
    // Then the smallest one that there may be, at which all who leave out nearly parallel edges
    // answer alike; its sine is less than 0.01.
    for (const double angle : {0.8, 0.0100001, 0.015, 0.03, 0.08}) {  // [rad]
      const auto [a, b] = crossing_rods(angle, any_number(0.05, 0.2));
      REQUIRE(is_right(a, b));
    }
    for (const double gap : {0.2, 0.01, -0.05})
      for (int n = 0; n < 3; ++n) {
        const auto [a, b] = edge_on_edge(gap);
        REQUIRE(is_right(a, b));
        REQUIRE(student::separation(a, b) == obeys("the gap is the distance of the edges",
                                                   std::abs(student::separation(a, b)->gap - gap),
                                                   rounding(a, b)));
      }
  }

  TEST_CASE("boxes far apart, near, and in one another") {
    for (const double distance : {8., 3., 2., 1., 0.5, 0.1})
      for (int n = 0; n < 4; ++n) {
        const auto [a, b] = any_two(distance);
        REQUIRE(is_right(a, b));
      }
  }

  TEST_CASE("swapped boxes have the same right gap, and a normal that is turned round") {
    for (int n = 0; n < 8; ++n) {
      const auto [a, b] = any_two(any_number(1, 4));
      const Separation there = student::separation(a, b).value();
      REQUIRE(is_right(a, b));
      const Separation back{there.gap, -there.normal};
      const auto swapped = student::separation(b, a);
      REQUIRE(swapped ==
              obeys("the gap is the same", std::abs(swapped->gap - back.gap), 2 * rounding(a, b)));
      REQUIRE(is_right(b, a));
      // Either normal may be off by what moves a gap by its rounding; twice that for both.
      REQUIRE(swapped == obeys("the normal is turned round", (swapped->normal - back.normal).norm(),
                               8000 * eps));
    }
  }

  TEST_CASE("the right gap: pushed apart by s along n it grows by s, moved together it stays") {
    for (int n = 0; n < 8; ++n) {
      const auto [a, b] = any_two(any_number(1, 3));
      const auto before = student::separation(a, b);
      REQUIRE(is_right(a, b));
      const double s = any_number(0.1, 2);
      Box pushed = b;
      pushed.centre += s * before->normal;
      const auto after = student::separation(a, pushed);
      REQUIRE(after == obeys("the gap is larger by s", std::abs(after->gap - before->gap - s),
                             4 * rounding(a, pushed)));
      const Mat3 turn = any_rotation();
      const Vec3 shift = any_vector(3);
      const auto elsewhere = student::separation(moved(a, turn, shift), moved(b, turn, shift));
      // A turned box is off by some roundings of its size and its place.
      REQUIRE(elsewhere ==
              obeys("the gap stays", std::abs(elsewhere->gap - before->gap), 8 * rounding(a, b)));
    }
  }

  TEST_CASE("an overlap is freed by a shift of -gap along the normal, and by no shorter one") {
    for (int n = 0; n < 6; ++n) {
      const auto [a, b] = any_two(any_number(0.1, 0.4));
      const auto overlap = student::separation(a, b);
      REQUIRE(overlap ==
              obeys("boxes in one another have a negative gap", worse(0, overlap->gap), 0));
      Box freed = b;
      freed.centre -= overlap->gap * overlap->normal;
      REQUIRE(student::separation(a, freed) == obeys("freed, the gap is 0",
                                                     std::abs(student::separation(a, freed)->gap),
                                                     4 * rounding(a, b)));
      for (int k = 0; k < 5; ++k) {
        Box still = b;
        still.centre -= 0.95 * overlap->gap * any_direction();
        const auto less = student::separation(a, still);
        REQUIRE(less == obeys("a shorter shift leaves an overlap", worse(0, less->gap), 0));
      }
    }
  }

  TEST_CASE("centres at one place, or side by side: a normal all the same") {
    const Box plate{any_vector(2), Mat3::Identity(), {4, 4, 0.25}};
    Box beside = plate;
    beside.centre.x() += 1;  // as high as the plate: nothing tells up from down
    REQUIRE(is_right(plate, beside));
    for (int n = 0; n < 4; ++n) {
      const auto [a, b] = any_two(0);
      REQUIRE(is_right(a, b));
    }
  }

  TEST_CASE("huge overlaps and tiny ones: boxes of 1e6 m and of 1e-6 m in one another") {
    for (const double scale : {1e-6, 5e5})
      for (const double distance : {0., 0.3, 1.}) {
        const auto [a, b] = scaled(any_two(distance), scale);
        REQUIRE(is_right(a, b));
      }
  }

  TEST_CASE("edges that are parallel up to rounding: far apart, their products would win") {
    for (const double angle : {5e-14, 5e-15}) {  // [rad]
      const Mat3 R = any_rotation();
      const Vec3 diagonal = R * Vec3(1, 1, 1);
      const Vec3 turn = angle * diagonal.normalized();
      const Box a{any_vector(1), R, {1, 2, 3}};
      Box b{a.centre + any_number(20, 40) * diagonal, R, {2, 1, 1}};
      for (int k = 0; k < 3; ++k) b.R.col(k) += turn.cross(R.col(k));
      REQUIRE(is_right(a, b));
    }
  }

  TEST_CASE("parallel edges: face on face, an edge along a face, turned about one axis") {
    for (int n = 0; n < 5; ++n) {
      const Mat3 R = any_rotation();
      const Box a{any_vector(1), R, {1, 2, 3}};
      const double distance = any_number(2, 4);
      Box b{a.centre + distance * any_direction(), R, {2, 1, 1}};
      REQUIRE(is_right(a, b));
      // One that is parallel up to rounding: the long way round, by three quarters of a turn.
      const Mat3 quarter = Eigen::AngleAxisd(std::numbers::pi / 2, R.col(2)).toRotationMatrix();
      b.R = quarter * (quarter * (quarter * R));
      REQUIRE(is_right(a, b));
      // Far apart along a diagonal: there a direction that is nothing but rounding would win.
      for (const Vec3& diagonal : {Vec3(1, 1, 1), Vec3(1, 1, -1), Vec3(1, -1, 1), Vec3(-1, 1, 1)}) {
        b.centre = a.centre + 10 * distance * R * diagonal;
        REQUIRE(is_right(a, b));
      }
      b.R = Eigen::AngleAxisd(any_number(0.2, 1.2), R.col(n % 3)).toRotationMatrix() * R;
      REQUIRE(is_right(a, b));
    }
  }

  TEST_CASE("a needle and a plate, a grain and a mountain, and 1e8 m from the origin") {
    const Vec3 needle(1e-6, 1e-6, 10), plate(5, 5, 1e-6);
    for (int n = 0; n < 3; ++n) {
      auto [a, b] = any_two(any_number(2, 6));
      a.size = needle;
      b.size = plate;
      REQUIRE(is_right(a, b));
      a.size = Vec3::Constant(1e-6);
      b.size = Vec3::Constant(1e6);
      const double distance = 1e6 * any_number(1, 3);
      b.centre = a.centre + distance * any_direction();
      REQUIRE(is_right(a, b));
      auto [far, near] = any_two(any_number(1, 4));
      for (Box* box : {&far, &near})
        box->centre = (box->centre * 1024).array().round().matrix() / 1024 + Vec3(1e8, -1e8, 1e8);
      REQUIRE(is_right(far, near));
    }
  }
}

const Misconceptions<decltype(when_bodies_meet::separation)> misconceptions{
    TUMBLE_UNIT,
    {{"six directions only",
      "You look along the boxes' edges only. Where an edge of one box crosses an edge of the "
      "other, "
      "you can see between them only along the product of both.",
      "A plane between two boxes",
      Reader{.directions =
                 [](const Box& a, const Box& b) {
                   Directions all;
                   add_edges(all, a, b);
                   return all;
                 }}},
     {"world axes",
      "You look along x, y and z of the world. These boxes are turned: look along their own edges.",
      "A plane between two boxes",
      Reader{.directions =
                 [](const Box&, const Box&) {
                   return Directions{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
                 }}},
     {"rows for columns",
      "You take the rows of R for the edges. R maps the box to the world: its columns are the "
      "edges.",
      "A plane between two boxes",
      [](Box a, Box b) {
        a.R.transposeInPlace();
        b.R.transposeInPlace();
        return reference(a, b);
      }},
     {"products not normalised",
      "Your gap along a product of two edges is measured with a vector that is shorter than 1. "
      "Divide the product by its length.",
      "A plane between two boxes",
      Reader{.directions =
                 [](const Box& a, const Box& b) {
                   Directions all;
                   add_edges(all, a, b);
                   for (const Vec3& product : products(a, b))
                     if (product.norm() > 1e-6) all.push_back(product);
                   return all;
                 }}},
     {"parallel edges divided by zero",
      "Where two edges are parallel, their product is zero, and you divide by its length. Leave it "
      "out: one of the edges' own directions does its work.",
      "A plane between two boxes",
      Reader{.directions =
                 [](const Box& a, const Box& b) {
                   Directions all;
                   for (const Vec3& product : products(a, b))
                     all.push_back(product / product.norm());
                   add_edges(all, a, b);
                   return all;
                 }}},
     {"product of parallel edges",
      "You keep the product of two parallel edges. It is nothing but rounding: divided by its "
      "length it points anywhere, and there the gap may be larger than along all 15 directions. "
      "Leave it out.",
      "A plane between two boxes",
      Reader{.directions = [](const Box& a, const Box& b) { return with_products(a, b, 0); }}},
     {"nearly parallel edges left out",
      "You leave out the product of two edges that are nearly parallel. Two long boxes may cross "
      "at just such an angle, and then nothing else shows the gap between them. Leave out only "
      "what is parallel up to rounding.",
      "A plane between two boxes",
      Reader{.directions = [](const Box& a, const Box& b) { return with_products(a, b, 0.01); }}},
     {"smallest gap",
      "You keep the smallest gap, which is the deepest overlap. One direction with a gap is enough "
      "to keep two boxes apart: keep the largest.",
      "A plane between two boxes",
      Reader{.better = [](double gap, double best) { return gap < best; }}},
     {"the search begins at −1000",
      "Your search begins with a gap of −1000, and these boxes overlap by more along every "
      "direction. "
      "Begin with a gap that is smaller than any other, or with the first direction.",
      "A plane between two boxes",
      [](const Box& a, const Box& b) {
        const Separation best = reference(a, b);
        return best.gap > -1000 ? best : Separation{-1000, Vec3::Zero()};
      }},
     {"no side, no normal",
      "Your normal is 0 where the centres are equally far along the direction: there n·d is 0, and "
      "so is its sign. Give either side; the gap is the same.",
      "A plane between two boxes",
      Reader{.side = [](double along) { return along > 0   ? 1.
                                               : along < 0 ? -1.
                                                           : 0.; }}},
     {"full edges",
      "Your boxes reach too far. From its centre a box reaches by half of its size to either side.",
      "A plane between two boxes",
      Reader{.reach = [](const Box& box, const Vec3& n) { return 2 * half_extent(box, n); }}},
     {"inscribed balls",
      "You let each box reach equally far along all directions, like a ball. Its corners reach "
      "farther than its faces.",
      "A plane between two boxes",
      Reader{.reach = [](const Box& box, const Vec3&) { return box.size.minCoeff() / 2; }}},
     {"signs not dropped",
      "You add the edges' shares with their signs. A box reaches to both sides of its centre: "
      "each edge adds ½ |n·edge|.",
      "A plane between two boxes",
      Reader{.reach = [](const Box& box, const Vec3& n) { return n.dot(box.R * box.size) / 2; }}},
     {"normal from B to A", "Your normal points from B to A.", "A plane between two boxes",
      changed([](Separation& s, const Box&, const Box&) { s.normal = -s.normal; })},
     {"no overlap below zero",
      "You return 0 where the boxes overlap. By how much they overlap is the answer there, as a "
      "negative gap.",
      "A plane between two boxes",
      changed([](Separation& s, const Box&, const Box&) { s.gap = std::fmax(0, s.gap); })},
     {"size of the overlap",
      "Where the boxes overlap your gap is positive. Only boxes that are apart have a positive "
      "gap.",
      "A plane between two boxes",
      changed([](Separation& s, const Box&, const Box&) { s.gap = std::abs(s.gap); })}}};
