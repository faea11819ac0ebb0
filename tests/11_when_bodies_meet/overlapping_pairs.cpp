/// @file
/// 11.1 overlapping_pairs: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "11_when_bodies_meet/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using tumble::Vec3;
using when_bodies_meet::Bounds, when_bodies_meet::Meet, when_bodies_meet::Pair;

namespace student {
const Function<decltype(when_bodies_meet::overlapping_pairs)> overlapping_pairs{TUMBLE_UNIT};
}

namespace {

using Pairs = std::vector<Pair>;
using Bodies = std::vector<Bounds>;

// ── Right and wrong answers, in parts ──

bool overlap_along(int axis, const Bounds& a, const Bounds& b) {
  return a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis];
}

bool overlap(const Bounds& a, const Bounds& b) {
  return overlap_along(0, a, b) && overlap_along(1, a, b) && overlap_along(2, a, b);
}

void sort(Pairs& pairs) {
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
}

/// A reader of the contract: which pairs are candidates, and what becomes of one.
struct Reader {
  bool (*candidates)(const Bounds& a, const Bounds& b) = overlap;
  bool (*asks)(const Meet& meet, int i, int j) = [](const Meet& meet, int i, int j) {
    return meet(i, j);
  };
  void (*finish)(Pairs& pairs) = [](Pairs&) {};

  Pairs operator()(const Bodies& bounds, const Meet& meet) const {
    Pairs pairs;
    const int n = static_cast<int>(bounds.size());
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j)
        if (candidates(at(bounds, i), at(bounds, j)) && asks(meet, i, j)) pairs.push_back({i, j});
    finish(pairs);
    return pairs;
  }
  static const Bounds& at(const Bodies& bounds, int i) {
    return bounds[static_cast<std::size_t>(i)];
  }
};

/// Where bodies begin at one place, std::sort may put either first: it is what students use.
std::vector<int> order_along_x(const Bodies& bounds) {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(bounds.size()); ++i) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return Reader::at(bounds, i).low.x() < Reader::at(bounds, j).low.x();
  });
  return order;
}

/// Sweeps along x, and keeps the pairs in the order in which it finds them.
Pairs in_the_order_of_the_sweep(const Bodies& bounds, const Meet& meet) {
  const std::vector<int> order = order_along_x(bounds);
  Pairs pairs;
  for (std::size_t n = 0; n < order.size(); ++n)
    for (std::size_t m = n + 1; m < order.size(); ++m) {
      const auto [i, j] = std::minmax(order[n], order[m]);
      if (Reader::at(bounds, order[m]).low.x() > Reader::at(bounds, order[n]).high.x()) break;
      if (overlap(Reader::at(bounds, i), Reader::at(bounds, j)) && meet(i, j))
        pairs.push_back({i, j});
    }
  return pairs;
}

/// Lets each body meet itself as well.
Pairs with_themselves(const Bodies& bounds, const Meet& meet) {
  Pairs pairs = Reader{}(bounds, meet);
  for (int i = 0; i < static_cast<int>(bounds.size()); ++i)
    if (meet(i, i)) pairs.push_back({i, i});
  sort(pairs);
  return pairs;
}

/// Looks at each body and the next one along x only.
Pairs neighbours_only(const Bodies& bounds, const Meet& meet) {
  const std::vector<int> order = order_along_x(bounds);
  Pairs pairs;
  for (std::size_t n = 1; n < order.size(); ++n) {
    const auto [i, j] = std::minmax(order[n - 1], order[n]);
    if (overlap(Reader::at(bounds, i), Reader::at(bounds, j)) && meet(i, j))
      pairs.push_back({i, j});
  }
  sort(pairs);
  return pairs;
}

/// Ends the sweep of a body at the first one that it does not overlap, in any direction.
Pairs stops_too_early(const Bodies& bounds, const Meet& meet) {
  const std::vector<int> order = order_along_x(bounds);
  Pairs pairs;
  for (std::size_t n = 0; n < order.size(); ++n)
    for (std::size_t m = n + 1; m < order.size(); ++m) {
      const auto [i, j] = std::minmax(order[n], order[m]);
      if (!overlap(Reader::at(bounds, i), Reader::at(bounds, j))) break;
      if (meet(i, j)) pairs.push_back({i, j});
    }
  sort(pairs);
  return pairs;
}

// ── Questions ──

/// Which of the pairs whose bounds overlap really meet: some two of three, as the numbers say.
/// (A student may ask for any two numbers.)
const Meet some_meet = [](int i, int j) {
  return (std::int64_t{i} * 7 + std::int64_t{j} * 13) % 3 != 0;
};
const Meet all_meet = [](int, int) { return true; };

/// Bodies of some size, scattered so that some ten pairs of a hundred bodies overlap.
Bodies any_bodies(int n, double size) {
  Bodies bodies;
  for (int i = 0; i < n; ++i) {
    const Vec3 centre = any_vector(1);
    const Vec3 half = size * Vec3{any_number(0.5, 1), any_number(0.5, 1), any_number(0.5, 1)};
    bodies.push_back({centre - half, centre + half});
  }
  return bodies;
}

/// Cubes with an edge of 1 on a grid, so that neighbours touch in a face, an edge or a corner, at
/// numbers that no rounding changes.
Bodies any_touching(int n) {
  Bodies bodies;
  for (int i = 0; i < n; ++i) {
    const Vec3 low = (2 * any_vector(1)).array().floor();
    bodies.push_back({low, low + Vec3::Ones()});
  }
  return bodies;
}

/// How often the pairs were asked for, less how often they should have been.
int wrong_questions(const Answer<Pairs>& answer, const Bodies& bodies) {
  std::map<std::pair<std::int64_t, std::int64_t>, int> asked;
  for (const Evaluation& each : answer.evaluations())
    ++asked[{from_value<int>(each.arguments[0]), from_value<int>(each.arguments[1])}];
  int wrong = 0;
  for (int i = 0; i < static_cast<int>(bodies.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(bodies.size()); ++j)
      if (overlap(Reader::at(bodies, i), Reader::at(bodies, j))) wrong += asked[{i, j}]-- != 1;
  for (const auto& [pair, times] : asked) wrong += times > 0;
  return wrong;
}

bool is_right(const Bodies& bodies, const Meet& meet) {
  const auto answer = student::overlapping_pairs(bodies, meet);
  return answer == close_to(Reader{}(bodies, meet), 0) &&
         answer ==
             obeys("`meet` is asked once for each pair whose bounds overlap, and for no other",
                   wrong_questions(answer, bodies), 0);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE(
      "bodies here and there: each overlapping pair asked for once, those that meet in order") {
    for (int n = 0; n < 6; ++n) REQUIRE(is_right(any_bodies(60, 0.25), some_meet));
  }

  TEST_CASE(
      "three boxes: two that touch, and one that stands apart; and two with one ulp between them") {
    const Bodies bodies{{{0, 0, 0}, {1, 1, 1}}, {{1, 0.5, 0.5}, {2, 2, 2}}, {{3, 0, 0}, {4, 1, 1}}};
    REQUIRE(is_right(bodies, all_meet));
    // Along each axis: a sweep along one of them settles that one by itself.
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 low = Vec3::Zero();
      low[axis] = std::nextafter(1., 2.);
      REQUIRE(is_right({{{0, 0, 0}, {1, 1, 1}}, {low, {2, 2, 2}}}, all_meet));
    }
  }

  TEST_CASE("touching counts: faces, edges and corners of cubes on a grid") {
    for (int n = 0; n < 6; ++n) REQUIRE(is_right(any_touching(20), all_meet));
  }

  TEST_CASE("none, one, several in the same place, and points") {
    REQUIRE(is_right({}, all_meet));
    const Vec3 a = any_vector(2), b = a + Vec3::Ones();
    REQUIRE(is_right({{a, b}}, all_meet));
    REQUIRE(is_right({{a, b}, {a, b}, {a, b}}, some_meet));
    REQUIRE(is_right({{a, a}, {b, b}, {a, b}, {a, a}}, all_meet));
  }

  TEST_CASE("one above the other, and one behind the other: each axis counts") {
    for (int axis = 0; axis < 3; ++axis) {
      Bodies bodies;
      for (int i = 0; i < 12; ++i) {
        const Vec3 low = 0.8 * i * Vec3::Unit(axis) + 0.1 * any_vector(1);
        bodies.push_back({low, low + Vec3::Ones()});
      }
      REQUIRE(is_right(bodies, all_meet));
    }
  }

  TEST_CASE("a large one over many small ones, which begin and end while it lasts") {
    for (int n = 0; n < 3; ++n) {
      Bodies bodies = any_bodies(30, 0.1);
      bodies.insert(bodies.begin() + n * 10, {Vec3::Constant(-2), Vec3(2, 2, 0)});
      REQUIRE(is_right(bodies, some_meet));
    }
  }

  TEST_CASE("a mirrored world has the same pairs, the right ones") {
    const Bodies bodies = any_bodies(60, 0.25);
    Bodies mirrored;
    for (const Bounds& each : bodies) mirrored.push_back({-each.high, -each.low});
    const auto pairs = student::overlapping_pairs(bodies, all_meet);
    REQUIRE(student::overlapping_pairs(mirrored, all_meet) == close_to(pairs.value(), 0));
    REQUIRE(is_right(mirrored, all_meet));
  }

  TEST_CASE("five thousand in a long row, in a wild order: two of them touch") {
    constexpr int n = 5000;
    Bodies row;
    Pairs expected;
    for (int i = 0; i < n; ++i) {
      const double x = static_cast<double>((i * 7919) % n);  // each place once, in a wild order
      row.push_back({{x, 0, 0}, {x + 0.5, 1, 1}});
    }
    // The first two places get a longer body, which reaches its neighbour.
    row[0].high.x() = 1;
    for (int i = 1; i < n; ++i)
      if (Reader::at(row, i).low.x() == 1) expected.push_back({0, i});
    REQUIRE(student::overlapping_pairs(row, all_meet) == close_to(expected, 0));
  }
}

const Misconceptions<decltype(when_bodies_meet::overlapping_pairs)> misconceptions{
    TUMBLE_UNIT,
    {{"touching left out",
      "You leave out bodies that only touch. Two intervals overlap also where one ends exactly at "
      "the place at which the other begins.",
      "Who can meet at all",
      Reader{.candidates =
                 [](const Bounds& a, const Bounds& b) {
                   return ((b.high - a.low).array() > 0).all() &&
                          ((a.high - b.low).array() > 0).all();
                 }}},
     {"z forgotten", "You compare x and y, but not z: for you a bird meets the fish below it.",
      "Who can meet at all",
      Reader{.candidates =
                 [](const Bounds& a, const Bounds& b) {
                   return overlap_along(0, a, b) && overlap_along(1, a, b);
                 }}},
     {"y forgotten", "You compare x and z, but not y: two bodies in one row are not yet together.",
      "Who can meet at all",
      Reader{.candidates =
                 [](const Bounds& a, const Bounds& b) {
                   return overlap_along(0, a, b) && overlap_along(2, a, b);
                 }}},
     {"one axis only",
      "You compare the bodies along x only. Those that the sweep finds together along x may still "
      "be far apart along y or z.",
      "Who can meet at all",
      Reader{
          .candidates = [](const Bounds& a, const Bounds& b) { return overlap_along(0, a, b); }}},
     {"one axis is enough",
      "You take bodies that overlap along x or y or z. To meet they must overlap along all three "
      "axes at the same time.",
      "Who can meet at all",
      Reader{.candidates =
                 [](const Bounds& a, const Bounds& b) {
                   return overlap_along(0, a, b) || overlap_along(1, a, b) ||
                          overlap_along(2, a, b);
                 }}},
     {"a corner must be inside",
      "You check whether the lowest corner of one body is inside the other. Two planks laid "
      "crosswise "
      "overlap, and neither has a corner in the other one.",
      "Who can meet at all",
      Reader{.candidates =
                 [](const Bounds& a, const Bounds& b) {
                   const auto holds = [](const Bounds& box, const Vec3& p) {
                     return (box.low.array() <= p.array()).all() &&
                            (p.array() <= box.high.array()).all();
                   };
                   return holds(a, b.low) || holds(b, a.low);
                 }}},
     {"`meet` never asked",
      "You return every pair whose bounds overlap. Bounds are larger than bodies: only `meet` "
      "knows whether two bodies really meet.",
      "Who can meet at all", Reader{.asks = [](const Meet&, int, int) { return true; }}},
     {"`meet` asked for all pairs",
      "You ask `meet` for bodies whose bounds are apart. That is the expensive question: the "
      "bounds "
      "are there to save you from it.",
      "Who can meet at all",
      [](const Bodies& bounds, const Meet& meet) {
        Pairs pairs;
        // Of 5000 bodies nobody can ask for all pairs.
        const int n = static_cast<int>(std::min<std::size_t>(bounds.size(), 100));
        for (int i = 0; i < n; ++i)
          for (int j = i + 1; j < n; ++j)
            if (meet(i, j) && overlap(Reader::at(bounds, i), Reader::at(bounds, j)))
              pairs.push_back({i, j});
        return pairs;
      }},
     {"asked twice", "You ask `meet` twice for the same pair. It is expensive: keep its answer.",
      "Who can meet at all",
      Reader{.asks = [](const Meet& meet, int i, int j) { return meet(i, j) && meet(i, j); }}},
     {"each pair twice",
      "You return each pair twice, once in either order. Give it once, the smaller number first.",
      "Who can meet at all",
      Reader{.finish =
                 [](Pairs& pairs) {
                   const Pairs once = pairs;
                   for (const auto& [i, j] : once) pairs.push_back({j, i});
                   sort(pairs);
                 }}},
     {"each with itself", "You let each body meet itself. A pair has two different numbers.",
      "Who can meet at all", with_themselves},
     {"in the order of the sweep",
      "Your pairs are the right ones, but in the order in which the sweep has found them. Sort "
      "them by the first number, then by the second.",
      "Who can meet at all", in_the_order_of_the_sweep},
     {"numbers of the sorted list",
      "Your numbers are the places of the bodies in the sorted list. Each body keeps the number "
      "that it came with: sort the numbers, not the bodies.",
      "Who can meet at all",
      [](const Bodies& bounds, const Meet& meet) {
        Bodies sorted;
        for (const int i : order_along_x(bounds)) sorted.push_back(Reader::at(bounds, i));
        return Reader{}(sorted, meet);
      }},
     {"those that don't meet", "You return the pairs for which `meet` says no.",
      "Who can meet at all",
      Reader{.asks = [](const Meet& meet, int i, int j) { return !meet(i, j); }}},
     {"larger number first", "Your pairs are the right ones, but with the larger number first.",
      "Who can meet at all",
      Reader{.finish =
                 [](Pairs& pairs) {
                   for (auto& [i, j] : pairs) std::swap(i, j);
                   sort(pairs);
                 }}},
     {"neighbours only",
      "You compare each body with the next one of the sweep only. A long body reaches over its "
      "next neighbour to those that come later.",
      "Who can meet at all", neighbours_only},
     {"sweep ended too early",
      "Your sweep of a body ends at the first one that it does not meet. It may end only at one "
      "that begins, along the axis of the sweep, where your body has ended.",
      "Who can meet at all", stops_too_early}}};
