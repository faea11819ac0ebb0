#pragma once

#include "tumble/mesh/parse_binary_stl.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/foreign_format.hpp"
#include "tumble/mesh/vertex_welder.hpp"

namespace tumble::detail {

TUMBLE_BODY bool is_binary_stl(std::string_view head, std::size_t size) {
  return head.size() >= stl_header_size &&
         (size - stl_header_size) / stl_facet_size == stl_facet_count(head) &&
         (size - stl_header_size) % stl_facet_size == 0;
}

TUMBLE_BODY void require_stl_size(std::string_view bytes, std::string_view name) {
  require(bytes.size() >= stl_header_size, name,
          ": a binary STL file has a header of 84 bytes, and this has ", bytes.size(), " bytes",
          about_foreign_format(bytes));
  const std::uint64_t count = stl_facet_count(bytes);
  const std::uint64_t needed = stl_header_size + stl_facet_size * count;
  require(bytes.size() == needed, name, ", byte 80: the header announces ", count,
          " facets, which take ", needed, " bytes, but the file has ", bytes.size(),
          about_foreign_format(bytes));
  constexpr std::uint64_t max_facets = 0x7FFFFFFF / 3;
  require(count <= max_facets, name, ", byte 80: ", count, " facets are more than the ", max_facets,
          " that a mesh holds");
}

TUMBLE_BODY Vec3 read_stl_vertex(ByteScanner& bytes, int facet) {
  const std::size_t begin = bytes.at();
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = double{bytes.next_float(ByteOrder::little)};
  if (!p.allFinite())
    bytes.refuse(begin, "facet #", facet + 1, " has the vertex (", p.x(), ", ", p.y(), ", ", p.z(),
                 "), which is not three finite numbers");
  return p;
}

TUMBLE_BODY PolygonMesh parse_binary_stl(std::string_view file, std::string_view name) {
  require_stl_size(file, name);
  const auto count = static_cast<int>(stl_facet_count(file));
  require(count > 0, name, ": no faces");
  ByteScanner bytes(file, stl_header_size, name);
  VertexWelder welder;
  PolygonMesh mesh;
  mesh.corners.reserve(3 * static_cast<std::size_t>(count));
  mesh.first_corner.reserve(static_cast<std::size_t>(count) + 1);
  for (int facet = 0; facet < count; ++facet) {
    bytes.skip(12);  // its normal
    for (int k = 0; k < 3; ++k)
      mesh.corners.push_back(welder.number_of(read_stl_vertex(bytes, facet)));
    mesh.first_corner.push_back(3 * (facet + 1));
    bytes.skip(2);  // attributes
  }
  mesh.vertices = welder.take_positions();
  return mesh;
}

}  // namespace tumble::detail
