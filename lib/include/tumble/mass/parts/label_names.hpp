#pragma once
/// @file
/// The names of labels, one by one and in words.

#include <array>
#include <string>
#include <vector>

#include "tumble/mesh/labelled_mesh.hpp"

namespace tumble::detail {

/// Everything that a label calls its faces: material, object, group, and of several groups each.
std::vector<std::string> names_of(const parts::Label& label);

/// What an OBJ file writes before a name, and the name.
struct KindOfName {
  const char* keyword;
  std::string parts::Label::*name;
};
inline constexpr std::array<KindOfName, 3> kinds_of_names = {{{"usemtl", &parts::Label::material},
                                                              {"g", &parts::Label::group},
                                                              {"o", &parts::Label::object}}};

/// `faces #13 to #24 (usemtl "steel", g "head")`.
std::string describe(const parts::LabelledMesh& mesh, const parts::LabelledFaces& faces);

/// All names in a file, or the first of them: `usemtl "steel", "rubber"; o "wheel"`.
std::string all_names(const parts::LabelledMesh& mesh);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mass/parts/label_names.inl"
#endif
