#pragma once
/// @file
/// Which format a mesh file has: by its content, and only where that says nothing by its name.

#include <string_view>

#include "tumble/mesh/text_scanner.hpp"

namespace tumble::detail {

enum class MeshFormat { obj, stl, ply };

inline bool ends_with(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         is_keyword(name.substr(name.size() - ending.size()), ending);
}

/// @param head the first bytes of the file, at least 84 if it has so many
/// @param size of the file [bytes]
MeshFormat format_of(std::string_view head, std::size_t size, std::string_view name);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/mesh_format.inl"
#endif
