#pragma once
/// @file
/// The words that a line of an OBJ text may begin with and that say nothing about positions, faces
/// and their names.
///
/// Source: Alias Wavefront, Advanced Visualizer manual, appendix B1, Object files (.obj).

#include <algorithm>
#include <array>
#include <string_view>

namespace tumble::detail {

/// Lines that are passed over, the frequent ones first; at the end two that are younger than the
/// format: the weights of a skin, and the tags of subdivision surfaces.
inline constexpr std::array<std::string_view, 35> obj_passed_over = {
    "vt",         "vn",        "s",     "l",     "p",        "mtllib",   "vp",  "cstype", "deg",
    "curv",       "curv2",     "parm",  "trim",  "hole",     "scrv",     "sp",  "end",    "con",
    "bmat",       "step",      "mg",    "bevel", "c_interp", "d_interp", "lod", "maplib", "usemap",
    "shadow_obj", "trace_obj", "ctech", "stech", "cdc",      "res",      "vw",  "t"};

/// Lines that are read.
inline constexpr std::array<std::string_view, 5> obj_read = {"v", "f", "o", "g", "usemtl"};

inline bool is_passed_over(std::string_view keyword) {
  return std::find(obj_passed_over.begin(), obj_passed_over.end(), keyword) !=
         obj_passed_over.end();
}

/// The keyword that differs from this word in capitals only, or nothing.
std::string_view obj_keyword_like(std::string_view word);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/obj_keywords.inl"
#endif
