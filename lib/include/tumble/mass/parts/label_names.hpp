#pragma once
/// @file
/// The names of labels, one by one and in words.

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "tumble/mesh/labelled_mesh.hpp"

namespace tumble::detail {

/// Everything that a label calls its faces: material, object, group, and of several groups each.
inline std::vector<std::string> names_of(const parts::Label& label) {
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name) {
    if (!name.empty()) names.push_back(name);
  };
  add(label.material);
  add(label.object);
  add(label.group);
  constexpr const char* blanks = " \t";
  for (std::size_t begin = 0; begin < label.group.size();) {
    const std::size_t end = std::min(label.group.find_first_of(blanks, begin), label.group.size());
    add(label.group.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

/// What an OBJ file writes before a name, and the name.
struct KindOfName {
  const char* keyword;
  std::string parts::Label::*name;
};
inline constexpr std::array<KindOfName, 3> kinds_of_names = {{{"usemtl", &parts::Label::material},
                                                              {"g", &parts::Label::group},
                                                              {"o", &parts::Label::object}}};

/// `faces #13 to #24 (usemtl "steel", g "head")`.
inline std::string describe(const parts::LabelledMesh& mesh, const parts::LabelledFaces& faces) {
  std::string text =
      "faces #" + std::to_string(faces.first + 1) + " to #" + std::to_string(faces.end);
  const char* before = " (";
  for (const auto& [keyword, name] : kinds_of_names) {
    const std::string& value = mesh.labels[static_cast<std::size_t>(faces.label)].*name;
    if (value.empty()) continue;
    text += before + (keyword + (" \"" + value + "\""));
    before = ", ";
  }
  return text + (*before == ',' ? ")" : "");
}

/// All names in a file, or the first of them: `usemtl "steel", "rubber"; o "wheel"`.
inline std::string all_names(const parts::LabelledMesh& mesh) {
  constexpr std::size_t shown = 12;
  std::string text;
  for (const auto& [keyword, name] : kinds_of_names) {
    std::set<std::string> seen = {""};
    for (const parts::Label& label : mesh.labels) {
      if (!seen.insert(label.*name).second || seen.size() > shown + 1) continue;
      text += seen.size() > 2 ? ", \"" : (text.empty() ? "" : "; ") + std::string(keyword) + " \"";
      text += label.*name + "\"";
    }
    if (seen.size() > shown + 1)
      text += " and " + std::to_string(seen.size() - 1 - shown) + " more";
  }
  return text;
}

}  // namespace tumble::detail
