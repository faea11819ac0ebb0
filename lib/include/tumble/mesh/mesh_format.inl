#pragma once

#include "tumble/mesh/mesh_format.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/parse_binary_stl.hpp"
#include "tumble/mesh/parse_stl.hpp"

namespace tumble::detail {

TUMBLE_BODY MeshFormat format_of(std::string_view head, std::size_t size, std::string_view name) {
  TextScanner text(head, name);
  if (text.peek_word() == "ply") return MeshFormat::ply;
  if (is_binary_stl(head, size) || is_text_stl(head)) return MeshFormat::stl;
  if (ends_with(name, ".stl")) return MeshFormat::stl;
  return ends_with(name, ".ply") ? MeshFormat::ply : MeshFormat::obj;
}

}  // namespace tumble::detail
