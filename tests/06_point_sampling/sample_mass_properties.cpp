/// @file
/// 6.3 sample_mass_properties: its laws, and what goes wrong.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "06_point_sampling/contract.hpp"
#include "06_point_sampling/inputs.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/grid_points.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/mass/point_sampling.hpp"

using namespace tumble::judge;
using point_sampling::Inside, point_sampling::MassProperties;
using tumble::Mat3, tumble::point_inertia, tumble::Vec3;

namespace student {
const Function<decltype(point_sampling::sample_mass_properties)> sample_mass_properties{
    TUMBLE_UNIT};
}

namespace {

const MassProperties nothing{0, Vec3::Zero(), Mat3::Zero()};

/// The box and its cells.
struct Grid {
  Vec3 low, high;
  int n;

  Vec3 size() const { return high - low; }
  Vec3 cell() const { return size() / n; }
  Vec3 middle() const { return low + size() / 2; }
  double points() const { return static_cast<double>(n) * n * n; }
  double volume() const { return size().prod(); }
  /// How far a place in it is from the origin, at most.
  double reach() const { return low.cwiseAbs().cwiseMax(high.cwiseAbs()).norm(); }
  /// Calls `visit(place)` for ((i + shift)/count, …) of the box, i, j, k = 0 … n − 1.
  template <class Visit>
  void for_each(double shift, double count, const Visit& visit) const {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k)
          visit(Vec3(low + size().cwiseProduct(Vec3(i, j, k) + Vec3::Constant(shift)) / count));
  }
};

/// A grid of n cells an edge in a box with edges of 1 to 3 m.
Grid any_grid(int n) {
  const Vec3 low = any_vector(3);
  const double x = any_number(1, 3), y = any_number(1, 3), z = any_number(1, 3);
  return {low, low + Vec3(x, y, z), n};
}

// ── Bodies ──

/// An ellipsoid in the box, off its middle, of which a plane has cut off a piece.
Inside any_body(const Grid& grid) {
  const Vec3 centre = grid.middle() + 0.1 * any_vector().cwiseProduct(grid.size());
  const Vec3 half = any_number(0.35, 0.6) * grid.size(), normal = any_direction();
  return [=](const Vec3& point) {
    const Vec3 r = (point - centre).cwiseQuotient(half);
    return r.squaredNorm() < 1 && r.dot(normal) < 0.3;
  };
}

/// Whole cells, some four of ten: rounding of a cell's middle cannot change what is inside.
Inside any_cells(const Grid& grid) {
  std::vector<bool> full(static_cast<std::size_t>(grid.n * grid.n * grid.n));
  for (std::size_t i = 0; i < full.size(); ++i) full[i] = any_number(0, 1) < 0.4;
  full[full.size() / 3] = true;
  return [=](const Vec3& point) -> bool {
    if (!point.allFinite()) return false;
    const Vec3 at = (point - grid.low).cwiseQuotient(grid.cell());
    const auto index = [&](int axis) {
      return static_cast<int>(std::clamp(at[axis], 0., grid.n - 0.5));
    };
    return full[static_cast<std::size_t>((index(0) * grid.n + index(1)) * grid.n + index(2))];
  };
}

// ── The right answer ──

/// What can be asked for "inside", for the library.
struct AskedBody {
  const Inside& inside;
  Eigen::AlignedBox3d box;
  bool contains(const Vec3& point) const { return inside(point); }
  const Eigen::AlignedBox3d& bounds() const { return box; }
};

MassProperties reference(const Inside& inside, const Vec3& low, const Vec3& high, int n,
                         double density) {
  try {
    const auto sampled = tumble::sampling::sample_mass_properties(
        AskedBody{inside, {low, high}}, density, tumble::sampling::GridPoints(n));
    return {sampled.mass, sampled.centre, sampled.inertia};
  } catch (const std::invalid_argument&) {
    return nothing;  // which the library refuses
  }
}

Answer<MassProperties> ask(const Inside& inside, const Grid& grid, double density) {
  return student::sample_mass_properties(inside, grid.low, grid.high, grid.n, density);
}

/// What rounding may do to mass, centre and inertia.
struct Rounding {
  double mass, centre, inertia;
  double largest() const { return std::max({mass, centre, inertia}); }
};

/// The sums of N terms round by N eps, the terms by some 8. Each place is off by eps of its
/// distance from the origin, which counts once in an inertia, times the size of the box.
Rounding rounding(const Grid& grid, double density) {
  const double sum = (16 + 4 * grid.points()) * eps, mass = density * grid.volume();
  return {sum * mass, sum * grid.reach(), 2 * sum * mass * grid.size().norm() * grid.reach()};
}

/// The same for someone who sums about the origin: allowed as long as the box is near it.
Rounding rounding_near_origin(const Grid& grid, double density) {
  const double sum = (16 + 4 * grid.points()) * eps, mass = density * grid.volume();
  return {sum * mass, sum * grid.reach(), 4 * sum * mass * grid.reach() * grid.reach()};
}

/// Each of the three to its own rounding.
bool agrees(const Answer<MassProperties>& answer, const MassProperties& expected,
            const Rounding& allowed) {
  const auto apart = [](const auto& a, const auto& b) {
    return (a - b).template lpNorm<Eigen::Infinity>();
  };
  return answer == obeys("the mass", std::abs(answer->mass - expected.mass), allowed.mass) &&
         answer ==
             obeys("the centre of mass", apart(answer->centre, expected.centre), allowed.centre) &&
         answer == obeys("the inertia about the centre of mass",
                         apart(answer->inertia, expected.inertia), allowed.inertia);
}

/// How far the points that were asked for are from the middles of the cells, at most; infinite if
/// some cell was not asked for exactly once.
double missed_by(const Answer<MassProperties>& answer, const Grid& grid) {
  std::vector<int> asked(static_cast<std::size_t>(grid.points()));
  double worst = 0;
  for (const Evaluation& each : answer.evaluations()) {
    const Vec3 point = from_value<Vec3>(each.arguments[0]);
    const Vec3 at = (point - grid.low).cwiseQuotient(grid.cell());
    if (!(at.array() >= 0).all() || !(at.array() < grid.n).all())
      return std::numeric_limits<double>::infinity();
    const Eigen::Vector3i cell = at.cast<int>();
    const Vec3 middle =
        grid.low + (cell.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(grid.cell());
    worst = worse(worst, (point - middle).lpNorm<Eigen::Infinity>());
    ++asked[static_cast<std::size_t>((cell.x() * grid.n + cell.y()) * grid.n + cell.z())];
  }
  const bool once = std::all_of(asked.begin(), asked.end(), [](int times) { return times == 1; });
  return once ? worst : std::numeric_limits<double>::infinity();
}

// ── Wrong answers ──

using Places = std::vector<Vec3>;

/// Those of the places ((i + shift)/count, …) of the box that are inside.
Places found(const Inside& inside, const Grid& grid, double shift, double count) {
  Places places;
  grid.for_each(shift, count, [&](const Vec3& place) {
    if (inside(place)) places.push_back(place);
  });
  return places;
}

Places found(const Inside& inside, const Grid& grid) { return found(inside, grid, 0.5, grid.n); }

Vec3 mean(const Places& places) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& place : places) sum += place;
  return sum / static_cast<double>(places.size());
}

/// Masses of `each` in these places, their inertia about `about`, which is given for their centre.
MassProperties with(const Places& places, double each, const Vec3& about) {
  if (places.empty()) return nothing;
  MassProperties result{each * static_cast<double>(places.size()), about, Mat3::Zero()};
  for (const Vec3& place : places) result.inertia += point_inertia(each, place - about);
  return result;
}

MassProperties with(const Places& places, double each) {
  return places.empty() ? nothing : with(places, each, mean(places));
}

/// The answer after `change(answer, grid, density)`.
template <class Change>
auto changed(const Change& change) {
  return [change](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
    MassProperties answer = reference(inside, low, high, n, density);
    if (answer.mass > 0) change(answer, Grid{low, high, n}, density);
    return answer;
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body, in any box, of any density") {
    for (const int n : {4, 5, 6, 3, 7}) {
      const Grid grid = any_grid(n);
      const double density = any_number(0.5, 3);
      const Inside body = any_body(grid);
      REQUIRE(ask(body, grid, density) == close_to(reference(body, grid.low, grid.high, n, density),
                                                   rounding_near_origin(grid, density).largest()));
    }
  }

  TEST_CASE("a box of whole cells has its true mass and centre, but lacks a cell's own inertia") {
    for (int turn = 0; turn < 3; ++turn) {
      const Grid grid = any_grid(6);
      const double density = any_number(0.5, 3);
      // The body's faces lie between cells: from 1 to 5, from 2 to 6, and all along.
      Vec3 from, to;
      for (int k = 0; k < 3; ++k) {
        const int axis = (k + turn) % 3;
        from[axis] = grid.low[axis] + k % 3 * grid.cell()[axis];
        to[axis] = grid.low[axis] + (k == 0 ? 6 : k + 4) * grid.cell()[axis];
      }
      const Vec3 edges = to - from;
      const double mass = density * edges.prod();
      // A box of edges a, b, c has m (b² + c²)/12 about x; what n cells lack is a cell's share.
      const Vec3 squares = edges.cwiseAbs2() - grid.cell().cwiseAbs2();
      const Mat3 inertia = mass / 12 * Mat3((Vec3::Constant(squares.sum()) - squares).asDiagonal());
      const auto body = [=](const Vec3& p) {
        return (p - from).minCoeff() > 0 && (to - p).minCoeff() > 0;
      };
      REQUIRE(ask(body, grid, density) ==
              close_to(MassProperties{mass, (from + to) / 2, inertia},
                       2 * rounding_near_origin(grid, density).largest()));
    }
  }

  TEST_CASE("twice as many cells an edge, a quarter of the error: it falls as h²") {
    const Grid coarse = any_grid(3), fine{coarse.low, coarse.high, 6};
    const auto everywhere = [](const Vec3&) { return true; };
    const Vec3 squares = coarse.size().cwiseAbs2();
    const auto error = [&](const Answer<MassProperties>& answer) {
      const double truth = coarse.volume() / 12 * (squares.y() + squares.z());
      return std::abs(answer->inertia(0, 0) - truth);
    };
    const auto a = ask(everywhere, coarse, 1), b = ask(everywhere, fine, 1);
    // Nearer to 2 than to any other whole number.
    REQUIRE(b == obeys("the error falls as h²", std::abs(std::log2(error(a) / error(b)) - 2), 0.5));
  }

  TEST_CASE("what is inside and what is outside add up to the mass and the centre of the box") {
    for (int n = 0; n < 3; ++n) {
      const Grid grid = any_grid(5);
      const double density = any_number(0.5, 3), whole = density * grid.volume();
      const Inside body = any_body(grid);
      const auto in = ask(body, grid, density);
      const auto out = ask([body](const Vec3& p) { return !body(p); }, grid, density);
      const Rounding allowed = rounding_near_origin(grid, density);
      REQUIRE(out == obeys("m + m′ is the mass of the box", std::abs(in->mass + out->mass - whole),
                           2 * allowed.mass));
      const Vec3 moment = in->mass * in->centre + out->mass * out->centre;
      // √3 of what each number of a centre may be off, times masses that add up to the whole.
      REQUIRE(out == obeys("m c + m′ c′ is that of the box",
                           (moment - whole * grid.middle()).norm(), 8 * whole * allowed.centre));
    }
  }

  TEST_CASE("nothing inside, a single cell, everything inside") {
    for (const int n : {1, 3}) {
      const Grid grid = any_grid(n);
      REQUIRE(ask([](const Vec3&) { return false; }, grid, 2) == close_to(nothing, 0));
      const Inside everywhere = [](const Vec3&) { return true; };
      REQUIRE(ask(everywhere, grid, 2) == close_to(reference(everywhere, grid.low, grid.high, n, 2),
                                                   rounding_near_origin(grid, 2).largest()));
    }
  }

  TEST_CASE("far from the origin only the rounding of the places counts") {
    for (const double far : {1e4, 1e6, 1e8}) {
      Grid grid = any_grid(4);
      const Vec3 place = far * any_direction();
      grid.low += place;
      grid.high += place;
      const Inside body = any_cells(grid);
      REQUIRE(agrees(ask(body, grid, 2), reference(body, grid.low, grid.high, grid.n, 2),
                     rounding(grid, 2)));
    }
  }

  TEST_CASE("tiny and huge bodies, light and heavy ones, long and flat boxes") {
    for (const double size : {1e-20, 1e-6, 1e6, 1e20}) {
      for (const Vec3& shape : {Vec3(1, 1, 1), Vec3(1e-3, 1, 1), Vec3(1, 1, 1e3)}) {
        Grid grid = any_grid(3);
        grid.low = size * grid.low.cwiseProduct(shape);
        grid.high = size * grid.high.cwiseProduct(shape);
        const double density = any_number(0, 1) < 0.5 ? 1e-50 : 1e50;
        const Inside body = any_cells(grid);
        REQUIRE(agrees(ask(body, grid, density),
                       reference(body, grid.low, grid.high, grid.n, density),
                       rounding_near_origin(grid, density)));
      }
    }
  }

  TEST_CASE("each cell is asked for once, in its middle: n³ evaluations") {
    for (const int n : {1, 2, 5}) {
      const Grid grid = any_grid(n);
      const auto answer = ask(any_body(grid), grid, 1);
      REQUIRE(answer ==
              obeys("inside is evaluated n³ times",
                    std::abs(static_cast<double>(answer.evaluations().size()) - grid.points()), 0));
      REQUIRE(answer == obeys("each cell is asked for once, in its middle", missed_by(answer, grid),
                              16 * eps * grid.reach()));
    }
  }
}

const Misconceptions<decltype(point_sampling::sample_mass_properties)> misconceptions{
    TUMBLE_UNIT,
    {{"corners for middles",
      "You have tested each cell at its corner with the smallest coordinates, so your points are "
      "not spread evenly about the middle of the box. A body that fills its box ends up half a "
      "cell too low, in each direction.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        const Grid grid{low, high, n};
        return with(found(inside, grid, 0, n), density * grid.cell().prod());
      }},
     {"from end to end",
      "Your points go from one face of the box to the opposite one. Those on the faces "
      "stand for half as much as the others, or less: ask in the middle of each cell.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        const Grid grid{low, high, n};
        return with(found(inside, grid, 0, std::max(n - 1, 1)), density * grid.cell().prod());
      }},
     {"a cubic metre for each point",
      "You have given each point the mass of a cubic metre. It stands for one cell: "
      "more points must not make a body heavier.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        return with(found(inside, Grid{low, high, n}), density);
      }},
     {"the full box shared out",
      "You have shared out all the mass that the box could hold among the points "
      "inside. But the cells outside are empty: their part is missing.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        const Grid grid{low, high, n};
        const Places places = found(inside, grid);
        return with(places, density * grid.volume() / static_cast<double>(places.size()));
      }},
     {"density forgotten",
      "Your mass is the volume, and your inertia that of a body of 1 kg/m³: multiply by "
      "the density.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double) {
        return reference(inside, low, high, n, 1);
      }},
     {"inertia of points of 1 kg",
      "Your mass and centre are right, but in the inertia each point counts as 1 kg. "
      "Give it the mass of its cell.",
      "The discrete inertia sum",
      changed([](MassProperties& body, const Grid& grid, double density) {
        body.inertia /= density * grid.cell().prod();
      })},
     {"inertia about the world's origin",
      "Your mass and centre are right, but your inertia is the one about the origin of "
      "the world.",
      "Parallel axes", changed([](MassProperties& body, const Grid&, double) {
        body.inertia += point_inertia(body.mass, body.centre);
      })},
     {"inertia about the middle of the box",
      "Your mass and centre are right, but your inertia is about the middle of the box. "
      "The centre of mass need not be there.",
      "Parallel axes", changed([](MassProperties& body, const Grid& grid, double) {
        body.inertia += point_inertia(body.mass, body.centre - grid.middle());
      })},
     {"centre of the box",
      "You have taken the middle of the box for the centre of mass. The body need not "
      "fill the box evenly.",
      "Counting points", changed([](MassProperties& body, const Grid& grid, double) {
        body.inertia += point_inertia(body.mass, body.centre - grid.middle());
        body.centre = grid.middle();
      })},
     {"divided by all points",
      "You have divided the sum of the places by n³. Only the points inside have gone "
      "into it.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        const Grid grid{low, high, n};
        const Places places = found(inside, grid);
        if (places.empty()) return nothing;
        const Vec3 about = mean(places) * static_cast<double>(places.size()) / grid.points();
        return with(places, density * grid.cell().prod(), about);
      }},
     {"measured from the corner",
      "This is the arrow from the box's corner `low` to the centre. Measure the centre "
      "from the world's origin.",
      "Counting points",
      changed([](MassProperties& body, const Grid& grid, double) { body.centre -= grid.low; })},
     {"products with a plus",
      "Mass, centre and the diagonal are right, but the products of inertia have the wrong sign.",
      "The discrete inertia sum", changed([](MassProperties& body, const Grid&, double) {
        const Mat3 diagonal = body.inertia.diagonal().asDiagonal();
        body.inertia = 2 * diagonal - body.inertia;
      })},
     {"cubes for cells",
      "You have made the cells as long along y and z as they are along x. The box may "
      "have three different edges, and so do its cells.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        const Vec3 cube = Vec3::Constant(high.x() - low.x());
        return reference(inside, low, low + cube, n, density);
      }},
     {"last cells left out",
      "You have left out the last layer of cells along each axis: check where your "
      "loops end.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        const Vec3 last = high - (high - low) / n;
        return n == 1 ? nothing : reference(inside, low, last, n - 1, density);
      }},
     {"cells with an inertia of their own",
      "You have added to each point the inertia of its cell about the middle. That is "
      "nearer to the truth for a box. But here we want point masses, so that you can "
      "see their error fall as h².",
      "Counting points", changed([](MassProperties& body, const Grid& grid, double) {
        const Vec3 squares = grid.cell().cwiseAbs2();
        body.inertia +=
            body.mass / 12 * Mat3((Vec3::Constant(squares.sum()) - squares).asDiagonal());
      })},
     {"zero over zero",
      "Where no point is inside, you have divided nothing by nothing to find the "
      "centre.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        const MassProperties answer = reference(inside, low, high, n, density);
        const double none = std::numeric_limits<double>::quiet_NaN();
        return answer.mass > 0 ? answer : MassProperties{0, Vec3::Constant(none), Mat3::Zero()};
      }},
     {"digits lost far from the origin",
      "Near the origin this is right. Far from it the inertia about the origin is huge, "
      "and rounding has eaten what the body has about its own centre. Take the "
      "differences of the places first.",
      "Far from the origin",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        const Grid grid{low, high, n};
        const double each = density * grid.cell().prod();
        const Places places = found(inside, grid);
        MassProperties body = with(places, each);
        if (body.mass > 0)
          body.inertia =
              with(places, each, Vec3::Zero()).inertia - point_inertia(body.mass, body.centre);
        return body;
      }},
     {"evaluated too often",
      "Your result is right, but you have asked for some points more than once. For a "
      "detailed mesh that costs time: keep what you were told.",
      "Counting points",
      [](const Inside& inside, const Vec3& low, const Vec3& high, int n, double density) {
        inside((low + high) / 2);
        return reference(inside, low, high, n, density);
      }}}};
