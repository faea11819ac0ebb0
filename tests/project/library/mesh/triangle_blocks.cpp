#include "tumble/mesh/triangle_blocks.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/sum_over_blocks.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

struct Triangle {
  int face;
  std::array<int, 3> vertices;
  bool operator==(const Triangle&) const = default;
};

/// `count` triangles between `vertices` vertices, in no order; the last vertex among them.
PolygonMesh any_triangles(int count, int vertices) {
  test::Random rng(41);
  PolygonMesh mesh;
  for (int v = 0; v < vertices; ++v) mesh.vertices.push_back(rng.vector());
  const auto any = [&] { return static_cast<int>(rng.uniform(0, vertices)); };
  for (int f = 0; f < count; ++f) {
    const int a = any(), b = any(), c = f == count / 2 ? vertices - 1 : any();
    mesh.add_face({a, b, c});
  }
  return mesh;
}

/// All triangles of the blocks of some faces, each checked for its coordinates.
std::vector<Triangle> from_blocks(const PolygonMesh& mesh, int first, int end) {
  std::vector<Triangle> list;
  TriangleBlocks(mesh).for_each(first, end, [&](const TriangleBlock& block) {
    CHECK(block.size % TriangleBlocks::widest_pack == 0);
    CHECK(block.padding < TriangleBlocks::widest_pack);
    for (int i = 0; i < block.size; ++i) {
      const int *v = block.vertices + 3 * i, *c = block.corners + 3 * i;
      if (i >= block.size - block.padding) {
        CHECK((c[0] == c[1] && c[1] == c[2]));
        continue;
      }
      list.push_back({block.face(i), {v[0], v[1], v[2]}});
      for (int k = 0; k < 3; ++k) {
        const Vec3& x = mesh.vertex(v[k]);
        const double* y = block.coordinates + 3 * c[k];
        CHECK((x.x() == y[0] && x.y() == y[1] && x.z() == y[2]));
      }
    }
  });
  return list;
}

std::vector<Triangle> by_faces(const PolygonMesh& mesh, int first, int end) {
  std::vector<Triangle> list;
  for_each_triangle(mesh, [&](int f, const std::array<int, 3>& t) {
    if (first <= f && f < end) list.push_back({f, t});
  });
  return list;
}

}  // namespace

TEST_CASE("TriangleBlocks: hand out every triangle once, in order, with its face and corners") {
  for (const int count : {1, 7, 8, 9, 511, 512, 513, 1100}) {
    const PolygonMesh mesh = any_triangles(count, 50);
    CAPTURE(count);
    CHECK((from_blocks(mesh, 0, count) == by_faces(mesh, 0, count)));
    CHECK((from_blocks(mesh, count / 3, count) == by_faces(mesh, count / 3, count)));
  }
}

TEST_CASE("TriangleBlocks: cut polygons into fans; faces with less than three corners have none") {
  PolygonMesh mesh = any_triangles(300, 50);
  mesh.add_face({1, 2, 3, 4, 5, 6});
  mesh.add_face({1, 2});
  mesh.add_face({});
  mesh.add_face({7, 8, 9, 49});
  const int faces = mesh.face_count();
  CHECK((from_blocks(mesh, 0, faces) == by_faces(mesh, 0, faces)));
  CHECK((from_blocks(mesh, 298, faces) == by_faces(mesh, 298, faces)));
  const PolygonMesh torus = test::torus(40, 30);
  CHECK((from_blocks(torus, 0, 1200) == by_faces(torus, 0, 1200)));
}

TEST_CASE("sum_over_blocks: all threads together count every triangle") {
  const PolygonMesh mesh = any_triangles(100'000, 1000);
  for (const int threads : {1, 4}) {
    const auto count = [](const TriangleBlock& block, int& sum) {
      sum += block.size - block.padding;
    };
    CHECK(sum_over_blocks<int>(mesh, {.threads = threads}, count) == 100'000);
  }
}
