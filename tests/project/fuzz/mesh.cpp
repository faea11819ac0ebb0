/// @file
/// libFuzzer on the diagnosis: bodies are put together, torn, bent, turned inside out and moved to
/// odd places as the bytes say, and held against the laws of check_mesh.hpp. A file of bytes would
/// hardly ever be closed; these often are.
#include <cstddef>
#include <cstdint>
#include <limits>

#include "project/fuzz/check_mesh.hpp"
#include "project/library/mesh/shapes.hpp"

namespace {

using namespace tumble;

/// Bytes as small decisions; 0 when there are no more.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  bool empty() const { return at_ == end_; }
  int next(int count) { return empty() ? 0 : *at_++ % count; }

 private:
  const std::uint8_t *at_, *end_;
};

double coordinate(Bytes& bytes) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double odd[] = {
      0,     -0.0,   1,     0.5,    -1,      1e-8, 1e8,  1e-160,
      1e160, 1e-300, 1e300, 5e-324, 1.0 / 3, inf,  -inf, std::numeric_limits<double>::quiet_NaN()};
  const int kind = bytes.next(48);
  return kind < 16 ? odd[kind] : (bytes.next(256) - 128) / 64.0;
}

Vec3 point(Bytes& bytes) {
  const double x = coordinate(bytes), y = coordinate(bytes), z = coordinate(bytes);
  return {x, y, z};
}

PolygonMesh body(Bytes& bytes) {
  switch (bytes.next(5)) {
    case 0:
      return test::cube();
    case 1:
      return test::triangulated(test::cube());
    case 2:
      return test::sphere(1);
    case 3:
      return test::torus(5, 4);
    default:
      return test::soup(test::cube());
  }
}

/// One of its own corners or vertices, if it has any.
std::size_t pick(Bytes& bytes, std::size_t count) {
  const std::size_t high = static_cast<std::size_t>(bytes.next(256));
  return (256 * high + static_cast<std::size_t>(bytes.next(256))) % count;
}

void change(PolygonMesh& mesh, Bytes& bytes) {
  const int f = static_cast<int>(pick(bytes, static_cast<std::size_t>(mesh.face_count())));
  switch (bytes.next(10)) {
    case 0:
      mesh.vertices[pick(bytes, mesh.vertices.size())] = point(bytes);
      break;
    case 1:
      mesh.corners[pick(bytes, mesh.corners.size())] = bytes.next(256) - 2;
      break;
    case 2:
      mesh = test::with_face_flipped(mesh, f);
      break;
    case 3:
      if (mesh.face_count() > 1) mesh = test::without_face(mesh, f);
      break;
    case 4:
      mesh = test::with_face_twice(mesh, f);
      break;
    case 5:
      mesh = test::inside_out(mesh);
      break;
    case 6:
      mesh = test::moved(mesh, coordinate(bytes), point(bytes));
      break;
    case 7:
      mesh.vertices[pick(bytes, mesh.vertices.size())] =
          mesh.vertices[pick(bytes, mesh.vertices.size())];
      break;
    case 8:
      mesh.first_corner[pick(bytes, mesh.first_corner.size())] = bytes.next(256) - 2;
      break;
    default:
      mesh = test::together(mesh, test::moved(body(bytes), coordinate(bytes), point(bytes)));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  PolygonMesh mesh = body(bytes);
  for (int i = 0;
       i < 12 && !bytes.empty() && detail::find_bad_indices(mesh).empty() && !mesh.corners.empty();
       ++i)
    change(mesh, bytes);
  fuzz::check_mesh(mesh);
  return 0;
}
