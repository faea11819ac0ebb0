#pragma once
/// @file
/// Lines of an OBJ text that bring in surfaces which its `v` and `f` do not show.
///
/// Source: Alias Wavefront, Advanced Visualizer manual, appendix B1, Object files (.obj).

#include <array>
#include <string_view>

namespace tumble::detail {

struct ObjElsewhere {
  std::string_view keyword;
  const char* what;
};

/// The general statements, the free-form surfaces, and the superseded patches and faces.
inline constexpr std::array<ObjElsewhere, 7> obj_elsewhere = {
    {{"call", "brings in another file, and we read this one alone"},
     {"csh", "brings in what a command prints, and we run no commands"},
     {"surf", "is a curved surface, and we read polygons: export a mesh"},
     {"bsp", "is a curved patch, and we read polygons: export a mesh"},
     {"bzp", "is a curved patch, and we read polygons: export a mesh"},
     {"cdp", "is a curved patch, and we read polygons: export a mesh"},
     {"fo", "is an old name of 'f': write 'f'"}}};

/// What a line with this keyword would add to the body, or null if nothing.
const char* what_is_elsewhere(std::string_view keyword);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/obj_elsewhere.inl"
#endif
