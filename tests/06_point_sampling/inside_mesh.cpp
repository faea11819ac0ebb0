/// @file
/// 6.2 inside_mesh: its laws, and what goes wrong.
///
/// A wrong ray looks wrong along its own direction only. So that a mistake can be named whichever
/// axis a student has chosen, the first cases ask from the origin of meshes that look the same
/// along all six half-axes. All questions of a case are asked before the first one is judged: one
/// answer, yes or no, says little about what went wrong.
#include <cmath>
#include <numbers>
#include <vector>

#include "06_point_sampling/bodies.hpp"
#include "06_point_sampling/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mesh/mesh_solid.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(point_sampling::inside_mesh)> inside_mesh{TUMBLE_UNIT};
}

namespace {

const Vec3 origin = Vec3::Zero();

bool reference(const Mesh& mesh, const Vec3& point) {
  if (mesh.triangles.empty()) return false;
  tumble::PolygonMesh polygons;
  polygons.vertices = mesh.vertices;
  for (const auto& [i, j, k] : mesh.triangles) polygons.add_face({i, j, k});
  return tumble::MeshSolid(polygons).contains(point);
}

struct Trial {
  Mesh mesh;
  Vec3 point;
};

/// Whether all answers are right.
bool all_right(const std::vector<Trial>& trials) {
  std::vector<Answer<bool>> answers;
  for (const auto& [mesh, point] : trials) answers.push_back(student::inside_mesh(mesh, point));
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (!(answers[i] == close_to(reference(trials[i].mesh, trials[i].point), 0))) return false;
  return true;
}

/// A tetrahedron near the axis x, at most 45° away from it.
Mesh any_piece(double from, double to) {
  const auto corner = [&] {
    const double x = any_number(from, to), y = any_number(-0.6, 0.6), z = any_number(-0.6, 0.6);
    return Vec3(x, y * from, z * from);
  };
  for (;;) {
    const Vec3 a = corner(), b = corner(), c = corner(), d = corner();
    const double volume = std::abs((b - a).dot((c - a).cross(d - a))) / 6;
    if (volume > 0.02 * from * from * from) return tetrahedron(a, b, c, d);
  }
}

/// An octahedron about the origin that looks the same along all six half-axes, from a side.
Mesh any_shell(double radius) {
  const Vec3 diagonal = Vec3::Ones().normalized();
  const Eigen::AngleAxisd turn(any_number(0.2, 0.8), diagonal);
  return mapped(octahedron(radius), turn.toRotationMatrix());
}

/// How many of the planes of a mesh the line from p along an axis meets, ahead of p.
int planes_ahead(const Mesh& mesh, const Vec3& p, int axis) {
  int count = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = vertex(mesh, t[0]), &b = vertex(mesh, t[1]), &c = vertex(mesh, t[2]);
    const Vec3 normal = (b - a).cross(c - a);
    if (normal.dot(a - p) / normal[axis] > 0) ++count;
  }
  return count;
}

/// A body askew, anywhere. (One draw a statement: arguments are evaluated in any order.)
Mesh any_turned_body() {
  const Mesh body = any_lattice_body();
  const Mat3 R = any_rotation();
  return mapped(body, R, any_vector(3));
}

/// The mesh seen from a place that was the origin.
Trial from_origin(const Mesh& mesh) {
  const Vec3 place = any_vector(3);
  return {shuffled(mapped(mesh, Mat3::Identity(), place)), place};
}

/// A tetrahedron around the point, with an odd number of its planes ahead along each axis.
Trial tetrahedron_with_planes_ahead() {
  for (;;) {
    const Vec3 a = any_vector(2), b = any_vector(2), c = any_vector(2), d = any_vector(2);
    const Mesh mesh = tetrahedron(a, b, c, d);
    const auto is_odd = [&](int axis) { return planes_ahead(mesh, origin, axis) % 2 == 1; };
    if (distance_to_surface(mesh, origin) > 0.1 && is_odd(0) && is_odd(1) && is_odd(2) &&
        reference(mesh, origin))
      return from_origin(mesh);
  }
}

/// An octahedron far away, beside all rays along the axes.
Trial far_away_along_the_diagonal() {
  return from_origin(octahedron(1, Vec3::Constant(any_number(4, 6))));
}

/// Near the corner of a large triangle; the middle of a smaller one behind it is nearer.
Trial in_front_of_a_large_triangle() {
  const Mat3 R = any_rotation();
  const Vec3 corner(0, 0, 0), place(0.3, 0.3, -0.4);
  return {mapped(tetrahedron(corner, {9, 0, 0}, {0, 9, 0}, {0.2, 0.2, 1}), R), R * place};
}

/// Slanted pieces all around: each ray along an axis enters a piece by the triangle whose middle is
/// farther away than that of the one by which it leaves.
Trial among_slanted_pieces() {
  return from_origin(six_times(tetrahedron({2, -1, 1}, {2, -1.1, -1}, {6, 3, 0.1}, {5, 1, -0.1})));
}

/// The same for lattice bodies: nothing is rounded.
Trial from_lattice_origin(const Mesh& mesh) {
  const int x = any_index(9) - 4, y = any_index(9) - 4, z = any_index(9) - 4;
  const Vec3 place(x, y, z);
  return {shuffled(mapped(mesh, Mat3::Identity(), place)), place};
}

/// Bodies that the half-axis x meets in corners and edges, or touches, or runs along.
std::vector<Mesh> pieces_with_traps() {
  return {
      tetrahedron({1, 0, 0}, {3, -1, -1}, {3, 2, -1}, {3, -1, 2}),  // in by a corner of three
      tetrahedron({2, -1, 0}, {2, 1, 0}, {5, 0, 3}, {5, 1, -3}),    // in by an edge
      tetrahedron({2, -1, 0}, {2, 1, 0}, {5, 0, 3}, {5, 0, -3}),    // and out by an edge
      tetrahedron({3, 0, 0}, {2, 1, 1}, {4, 1, 1}, {3, 2, -1}),     // touched in a corner
      tetrahedron({3, 0, -1}, {3, 0, 1}, {2, 1, 0}, {4, 1, 0}),     // touched in an edge
      tetrahedron({2, 0, 0}, {4, 0, 0}, {3, 1, 1}, {3, 1, -1}),     // along an edge
      tetrahedron({2, 0, -1}, {5, 0, -1}, {3, 0, 2}, {3, 1, 0}),    // along a face
      tetrahedron({2, 0, 0}, {5, 0, -1}, {4, 0, 2}, {4, 2, 0}),     // along it from a corner on
      box({2, 0, -1}, {4, 1, 1}),                                   // along a wall
      box({2, 0, 0}, {4, 1, 1}),                                    // along the edge of a wall
      box({2, -1, -1}, {4, 1, 1}),                                  // through two diagonals
      octahedron(1, {4, 0, 0}),                                     // through corners of four
  };
}

/// A place straight beside a corner, an edge or the middle of a triangle, along an axis, and clear
/// of the surface.
/// @param along where on an edge, as a fraction of its length
Vec3 any_place_beside(const Mesh& mesh, int axis, double along) {
  for (;;) {
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(any_index(mesh.triangles.size()))];
    const Vec3 &a = vertex(mesh, t[0]), &b = vertex(mesh, t[1]), &c = vertex(mesh, t[2]);
    const int kind = any_index(4);
    const Vec3 mark = kind == 0 ? a : kind == 3 ? Vec3((a + b + 2 * c) / 4) : a + along * (b - a);
    const double step = any_number(-1, 1) < 0 ? -0.25 : 0.25, way = step * (1 + any_index(7));
    const Vec3 place = mark + way * Vec3::Unit(axis);
    if (distance_to_surface(mesh, place) > 0.1) return place;
  }
}

// ── Wrong answers ──

/// Twice the areas of the three triangles that the vertical line makes with the edges, with signs.
Vec3 areas_around(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const auto area = [&](const Vec3& u, const Vec3& v) {
    return (u.x() - p.x()) * (v.y() - p.y()) - (u.y() - p.y()) * (v.x() - p.x());
  };
  return {area(b, c), area(c, a), area(a, b)};
}

/// Where the vertical line meets the triangle's plane, above p [m]; NaN if it runs along it.
double height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 areas = areas_around(a, b, c, p);
  const double all = areas.sum();
  return all == 0 ? std::nan("") : areas.dot(Vec3(a.z(), b.z(), c.z())) / all - p.z();
}

/// How many triangles the ray upwards meets, if `meets(a, b, c, p)` says whether its line does.
template <class Meets>
int hits(const Mesh& mesh, const Vec3& p, const Meets& meets) {
  int count = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = vertex(mesh, t[0]), &b = vertex(mesh, t[1]), &c = vertex(mesh, t[2]);
    if (meets(a, b, c, p) && height(a, b, c, p) > 0) ++count;
  }
  return count;
}

bool meets_closed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 areas = areas_around(a, b, c, p);
  return areas.minCoeff() >= 0 || areas.maxCoeff() <= 0;
}

bool meets_open(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 areas = areas_around(a, b, c, p);
  return areas.minCoeff() > 0 || areas.maxCoeff() < 0;
}

/// Does the edge from u to v, seen from above, cross the half-line from p towards +x? 1 if it does
/// so towards +y, −1 if towards −y.
int crossing(const Vec3& u, const Vec3& v, const Vec3& p) {
  const bool up = v.y() > p.y();
  if ((u.y() > p.y()) == up) return 0;
  const double left = (v.x() - u.x()) * (p.y() - u.y()) - (v.y() - u.y()) * (p.x() - u.x());
  return up ? (left > 0 ? 1 : 0) : (left < 0 ? -1 : 0);
}

/// Right but for rounding: on which side of an edge the line passes is found from where the edge
/// begins, which is another end for the other triangle.
bool meets_half_open(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  return crossing(a, b, p) + crossing(b, c, p) + crossing(c, a, p) != 0;
}

/// Right: both triangles of an edge find that from its lower end.
bool meets(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const auto from_below = [&](const Vec3& u, const Vec3& v) {
    return u.y() < v.y() ? crossing(u, v, p) : -crossing(v, u, p);
  };
  return from_below(a, b) + from_below(b, c) + from_below(c, a) != 0;
}

/// A place from which the ray along this half-axis is counted wrongly by who rounds like that.
Trial rounding_trap(int axis, double sign) {
  // The half-axis becomes the one upwards.
  Mat3 turn = Mat3::Zero();
  for (int i = 0; i < 3; ++i) turn(i, (axis + 1 + i) % 3) = i == 2 ? sign : 1;
  for (;;) {
    const Mesh mesh = any_turned_body();
    const Mesh upright = mapped(mesh, turn);
    for (int n = 0; n < 20; ++n) {
      const Vec3 place = any_place_beside(mesh, axis, any_number(0.1, 0.9));
      const bool counted = hits(upright, turn * place, meets_half_open) % 2 == 1;
      if (counted != reference(mesh, place)) return {mesh, place};
    }
  }
}

/// The sum over the triangles of `angle(product, sum)`: the solid angle that each fills, seen from
/// p, is 2 atan2 of these. Source: Van Oosterom & Strackee, "The solid angle of a plane triangle",
/// IEEE Transactions on Biomedical Engineering 30 (1983).
template <class Angle>
double solid_angle(const Mesh& mesh, const Vec3& p, const Angle& angle) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = vertex(mesh, t[0]) - p, b = vertex(mesh, t[1]) - p, c = vertex(mesh, t[2]) - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += angle(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum;
}

bool is_behind(const Mesh& mesh, const Triangle& t, const Vec3& p) {
  const Vec3 &a = vertex(mesh, t[0]), &b = vertex(mesh, t[1]), &c = vertex(mesh, t[2]);
  return (p - a).dot((b - a).cross(c - a)) < 0;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("a point is inside where the surface goes round it, of whatever parts it is made") {
    // Off the axes: no ray along one meets these. On them, but so far away that they look small.
    const Mesh off = six_times(octahedron(0.5, {3, 2, -1.5})),
               on = six_times(octahedron(0.5, {6, 0.1, 0.2}));
    std::vector<Trial> trials{tetrahedron_with_planes_ahead(),
                              far_away_along_the_diagonal(),
                              from_origin(off),
                              from_origin(on),
                              from_origin(joined({any_shell(0.9), off})),
                              among_slanted_pieces()};
    for (int n = 0; n < 4; ++n) {
      const Mesh pieces = six_times(any_piece(1, 3)), small = any_shell(0.9);
      const Mesh large = any_shell(20), wall = inside_out(any_shell(8));
      trials.push_back(from_origin(small));
      trials.push_back(from_origin(pieces));
      trials.push_back(from_origin(joined({small, pieces})));
      trials.push_back(from_origin(joined({large, inside_out(pieces)})));
      trials.push_back(from_origin(joined({large, wall})));
      trials.push_back(from_origin(joined({large, wall, small})));
    }
    REQUIRE(all_right(trials));
    trials = {in_front_of_a_large_triangle()};
    for (int n = 0; n < 40; ++n) {
      const Mesh mesh = any_turned_body();
      trials.push_back({mesh, any_place_near(mesh)});
    }
    REQUIRE(all_right(trials));
  }

  TEST_CASE(
      "where a line meets a corner or an edge, touches one or runs along, the answer is right") {
    // Small ones first: what is shown of a wrong answer can be drawn on paper.
    const Mesh cube = box(Vec3::Constant(-1), Vec3::Constant(1));
    std::vector<Trial> trials{from_lattice_origin(octahedron(1)), from_lattice_origin(cube)};
    for (const Mesh& piece : pieces_with_traps()) {
      const Mesh pieces = six_times(piece);
      trials.push_back(from_lattice_origin(pieces));
      trials.push_back(from_lattice_origin(joined({octahedron(0.5), pieces})));
      trials.push_back(from_lattice_origin(joined({mapped(cube, Mat3::Identity() / 2), pieces})));
    }
    REQUIRE(all_right(trials));
  }

  TEST_CASE("straight above, below and beside the corners and edges of bodies of all shapes") {
    for (const Mesh& body : lattice_bodies()) {
      const Mesh mesh = shuffled(mapped(body, any_lattice_symmetry()));
      std::vector<Trial> trials;
      for (int n = 0; n < 12; ++n) trials.push_back({mesh, any_place_beside(mesh, n % 3, 0.5)});
      REQUIRE(all_right(trials));
    }
  }

  TEST_CASE("beside edges that are turned: rounding must not count them twice or never") {
    std::vector<Trial> trials;
    for (int n = 0; n < 12; ++n) trials.push_back(rounding_trap(n % 3, n % 2 == 0 ? 1 : -1));
    REQUIRE(all_right(trials));
  }

  TEST_CASE("notches, holes, cavities and gaps between parts are outside, what fills them is not") {
    const Mat3 S = any_lattice_symmetry();
    const auto holds = [&](const Mesh& mesh, const Vec3& inside, const Vec3& outside) {
      const Mesh turned = shuffled(mapped(mesh, S));
      const Vec3 nudge = any_vector(0.2);
      return student::inside_mesh(turned, S * (inside + nudge)) == close_to(true, 0) &&
             student::inside_mesh(turned, S * (outside + nudge)) == close_to(false, 0);
    };
    const auto bodies = lattice_bodies();
    REQUIRE(holds(bodies[3], {0.5, 0.5, 0.5}, {1.5, 1.5, 0.5}));  // an L
    REQUIRE(holds(bodies[4], {2.5, 1.5, 0.5}, {1.5, 1.5, 0.5}));  // a U
    REQUIRE(holds(bodies[5], {1.5, 0.5, 0.5}, {1.5, 1.5, 0.5}));  // a frame
    REQUIRE(holds(bodies[7], {1.5, 1.5, 0.5}, {1.5, 1.5, 1.5}));  // an empty room
    REQUIRE(holds(bodies[9], {2.5, 0.5, 0.5}, {1.5, 0.5, 0.5}));  // two cubes
    REQUIRE(student::inside_mesh(bodies[8], {1.5, 1.5, 1.5}) == close_to(true, 0));
    REQUIRE(student::inside_mesh(bodies[8], {1.1, 1.6, 1.5}) == close_to(false, 0));
  }

  TEST_CASE("two thousandths of its size below the surface is inside, above it is outside") {
    for (int n = 0; n < 5; ++n) {
      const Mesh mesh = any_turned_body();
      const double step = 2e-3 * extent(mesh);
      for (int k = 0; k < 4; ++k) {
        const Triangle& t =
            mesh.triangles[static_cast<std::size_t>(any_index(mesh.triangles.size()))];
        const Vec3 &a = vertex(mesh, t[0]), &b = vertex(mesh, t[1]), &c = vertex(mesh, t[2]);
        // A spot of the triangle that keeps away from its edges.
        const Vec3 spot = (a + b + c) / 3 + any_number(-0.2, 0.2) * (b - a);
        const Vec3 normal = (b - a).cross(c - a).normalized();
        REQUIRE(student::inside_mesh(mesh, spot - step * normal) == close_to(true, 0));
        REQUIRE(student::inside_mesh(mesh, spot + step * normal) == close_to(false, 0));
      }
    }
  }

  TEST_CASE("tiny and huge bodies, near the origin and far from it") {
    // One point of each kind: who always says "outside" must not be right by luck.
    const auto tells_apart = [](const Mesh& body, double size, const Mat3& R, const Vec3& place) {
      for (const bool inside : {true, false}) {
        Vec3 p = any_place_near(body);
        while (reference(body, p) != inside) p = any_place_near(body);
        if (!(student::inside_mesh(mapped(body, size * R, size * place), size * (R * p + place)) ==
              close_to(inside, 0)))
          return false;
      }
      return true;
    };
    for (const double size : {1e-50, 1e-6, 1e6, 1e50}) {
      const Mesh body = any_lattice_body();
      const Mat3 R = any_rotation();
      const Vec3 place = any_number(0, 1) < 0.5 ? origin : any_vector(1e6);
      REQUIRE(tells_apart(body, size, R, place));
    }
    for (const double size : {1e-50, 1e50})
      for (const double far : {0., 1e6}) {
        const Mesh body = any_lattice_body();
        const Mat3 R = any_rotation();
        REQUIRE(tells_apart(body, size, R, far * any_direction()));
      }
  }

  TEST_CASE("nothing is inside a mesh without triangles") {
    REQUIRE(student::inside_mesh({}, any_vector()) == close_to(false, 0));
    REQUIRE(student::inside_mesh({octahedron(2).vertices, {}}, origin) == close_to(false, 0));
  }
}

const Misconceptions<decltype(point_sampling::inside_mesh)> misconceptions{
    TUMBLE_UNIT,
    {{"edges counted twice",
      "You have counted a ray that meets an edge for both of its triangles, as if it "
      "had passed two walls, and at a corner even more often. Count it once.",
      "A ray that meets an edge",
      [](const Mesh& mesh, const Vec3& p) { return hits(mesh, p, meets_closed) % 2 == 1; }},
     {"edges never counted",
      "You have not counted a ray that meets an edge or a corner, as if there were a "
      "gap between the triangles. Count it once.",
      "A ray that meets an edge",
      [](const Mesh& mesh, const Vec3& p) { return hits(mesh, p, meets_open) % 2 == 1; }},
     {"each triangle rounds for itself",
      "On which side of an edge does the ray pass? You have rounded that in one way for "
      "one of its triangles and in another way for the other, so both of them may "
      "count, or none. Let the numbers that decide be the very same for both.",
      "A ray that meets an edge",
      [](const Mesh& mesh, const Vec3& p) { return hits(mesh, p, meets_half_open) % 2 == 1; }},
     {"any hit is inside",
      "You have taken a point to be inside if its ray meets the surface. But a ray from "
      "outside may go in and out again: ask how often it does.",
      "Is a point inside?",
      [](const Mesh& mesh, const Vec3& p) { return hits(mesh, p, meets) > 0; }},
     {"exactly one hit",
      "You have taken a point to be inside if its ray meets the surface just once. But "
      "a ray from inside a body with notches, or of several parts, may leave, come in "
      "and leave again.",
      "Is a point inside?",
      [](const Mesh& mesh, const Vec3& p) { return hits(mesh, p, meets) == 1; }},
     {"nothing is inside",
      "Your answer is always false. Do you count hits behind the point? A line goes in "
      "as often as it comes out, so its hits are never odd in number. A ray begins at "
      "the point.",
      "Is a point inside?", [](const Mesh&, const Vec3&) { return false; }},
     {"planes for triangles",
      "You have counted where the ray meets the plane of a triangle, wherever in the "
      "plane that is. It has to meet the triangle.",
      "Does the ray meet this triangle?",
      [](const Mesh& mesh, const Vec3& p) {
        const auto always = [](const Vec3&, const Vec3&, const Vec3&, const Vec3&) { return true; };
        return hits(mesh, p, always) % 2 == 1;
      }},
     {"in the box around it",
      "You have compared the point with the box around the mesh. Much of that box may "
      "be outside of the body.",
      "Is a point inside?",
      [](const Mesh& mesh, const Vec3& p) {
        return !mesh.triangles.empty() && bounds_of(mesh).contains(p);
      }},
     {"behind all triangles",
      "You have taken a point to be inside if it is on the inner side of all triangles. "
      "That is right only for a convex body: the walls of a notch have the body on "
      "either side.",
      "Does the ray meet this triangle?",
      [](const Mesh& mesh, const Vec3& p) {
        return !mesh.triangles.empty() &&
               std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                           [&](const Triangle& t) { return is_behind(mesh, t, p); });
      }},
     {"everything is inside", "Your answer is always true, even for a mesh without triangles.",
      "Is a point inside?", [](const Mesh&, const Vec3&) { return true; }},
     {"behind some triangle",
      "You have taken a point to be inside if it is on the inner side of any triangle. "
      "Every body has such a triangle on its far side.",
      "Does the ray meet this triangle?",
      [](const Mesh& mesh, const Vec3& p) {
        return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                           [&](const Triangle& t) { return is_behind(mesh, t, p); });
      }},
     {"the triangle with the nearest middle decides",
      "You have let one triangle decide, the one whose middle is nearest. Large "
      "triangles have their middles far away, and near an edge the other triangle may "
      "be the right one to ask.",
      "Does the ray meet this triangle?",
      [](const Mesh& mesh, const Vec3& p) {
        const auto distance = [&](const Triangle& t) {
          return (vertex(mesh, t[0]) + vertex(mesh, t[1]) + vertex(mesh, t[2]) - 3 * p).norm();
        };
        const auto nearest = std::min_element(
            mesh.triangles.begin(), mesh.triangles.end(),
            [&](const Triangle& s, const Triangle& t) { return distance(s) < distance(t); });
        return nearest != mesh.triangles.end() && is_behind(mesh, *nearest, p);
      }},
     {"solid angles without a sign",
      "You have added up the solid angles without their signs. From outside, the fronts "
      "that you see cancel the backs: only so does the sum become zero.",
      "Is a point inside?",
      [](const Mesh& mesh, const Vec3& p) {
        return solid_angle(mesh, p, [](double product, double sum) {
                 return 2 * std::abs(std::atan2(product, sum));
               }) > 2 * std::numbers::pi;
      }},
     {"arc tangent of a quotient",
      "Your large solid angles are wrong. The arc tangent of a quotient cannot tell an "
      "angle from one that is half a turn larger; the one with two arguments can.",
      "Is a point inside?", [](const Mesh& mesh, const Vec3& p) {
        return solid_angle(mesh, p, [](double product, double sum) {
                 return 2 * std::atan(product / sum);
               }) > 2 * std::numbers::pi;
      }}}};
