#pragma once
/// @file
/// Binary STL in memory.
///
/// Source: 3D Systems, StereoLithography Interface Specification (1988), as in M. Burns, Automated
/// Fabrication (1993), section 6.5: 80 bytes of any text, the number of facets, and for each a
/// normal, three vertices (single precision, the lowest byte first) and two more bytes.

#include <string_view>

#include "tumble/mesh/byte_scanner.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {

inline constexpr std::size_t stl_header_size = 84, stl_facet_size = 50;

/// The number of facets that the header names.
/// @param bytes at least a header
inline std::uint32_t stl_facet_count(std::string_view bytes) {
  return load<std::uint32_t>(bytes.data() + 80, ByteOrder::little);
}

/// Whether a file of this size, with this header, is as long as its facets. A text never is: four
/// letters would be 150 million facets at least, and 7 GB.
/// @param head the first bytes of the file, or all
bool is_binary_stl(std::string_view head, std::size_t size);

void require_stl_size(std::string_view bytes, std::string_view name);

Vec3 read_stl_vertex(ByteScanner& bytes, int facet);

/// @throws std::invalid_argument as parse_stl() does
PolygonMesh parse_binary_stl(std::string_view file, std::string_view name);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/parse_binary_stl.inl"
#endif
