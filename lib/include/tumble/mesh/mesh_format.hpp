#pragma once
/// @file
/// Which format a mesh file has: by its content, and only where that says nothing by its name.

#include <string_view>

#include "tumble/mesh/parse_stl.hpp"
#include "tumble/mesh/text_scanner.hpp"

namespace tumble::detail {

enum class MeshFormat { obj, stl, ply };

inline bool ends_with(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         is_keyword(name.substr(name.size() - ending.size()), ending);
}

/// @param head the first bytes of the file, at least 84 if it has so many
/// @param size of the file [bytes]
inline MeshFormat format_of(std::string_view head, std::size_t size, std::string_view name) {
  TextScanner text(head, name);
  if (text.peek_word() == "ply") return MeshFormat::ply;
  if (is_binary_stl(head, size) || is_text_stl(head)) return MeshFormat::stl;
  if (ends_with(name, ".stl")) return MeshFormat::stl;
  return ends_with(name, ".ply") ? MeshFormat::ply : MeshFormat::obj;
}

}  // namespace tumble::detail
