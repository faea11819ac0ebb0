#pragma once
/// @file
/// What a file is that is not the mesh that was looked for: by the first bytes, for messages.

#include <array>
#include <string>
#include <string_view>

namespace tumble::detail {

struct Beginning {
  std::string_view bytes;
  const char* what;
};

/// What a file that begins with these bytes is; sources: RFC 1952 (gzip), the ZIP, STL, PLY, OFF,
/// glTF 2.0 and Git LFS specifications, the byte order marks of Unicode.
inline constexpr std::array<Beginning, 12> beginnings = {
    {{"\x1F\x8B", "gzip: unpack it first"},
     {"PK\x03\x04", "ZIP: unpack it first"},
     {"solid", "STL"},
     {"ply", "PLY"},
     {"glTF", "glTF"},
     {"OFF", "OFF"},
     {"<", "XML or HTML"},
     {"{", "JSON"},
     {"version https://git-lfs", "a Git LFS pointer"},
     {"\xFF\xFE", "UTF-16"},
     {"\xFE\xFF", "UTF-16"},
     {"\x7F"
      "ELF",
      "a program"}}};

/// ": it begins like …", or nothing if it is not known.
std::string about_foreign_format(std::string_view bytes);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/foreign_format.inl"
#endif
