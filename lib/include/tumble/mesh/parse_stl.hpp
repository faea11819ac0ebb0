#pragma once
/// @file
/// The facets of an STL file in memory, binary or ASCII.

#include <string_view>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {
/// Whether the first word is `solid` and no byte is 0, as in no text, but those that fill up the
/// end.
/// @param head the first bytes of the file, or all
bool is_text_stl(std::string_view head);

/// Reads an STL file. Vertices at equal positions become one (0 and −0 are equal, nothing else is
/// moved); normals, names and colours are passed over. STL states no unit: coordinates are taken
/// for metres.
/// @param bytes of the file. It is binary where its size is that of the facets that its header
///              names, also if it begins with "solid". Bytes 0 may fill up the end of a text
/// @param name  what the file is called in messages
/// @throws std::invalid_argument naming the facet, and the line or the byte, for: a file that is
///         shorter or longer than its facets, a facet without three vertices, a coordinate that is
///         not a finite number, a word that does not belong there, a file without facets
PolygonMesh parse_stl(std::string_view bytes, std::string_view name);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/parse_stl.inl"
#endif
