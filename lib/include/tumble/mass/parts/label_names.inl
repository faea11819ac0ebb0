#pragma once

#include "tumble/mass/parts/label_names.hpp"

#include <algorithm>
#include <set>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<std::string> names_of(const parts::Label& label) {
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

TUMBLE_BODY std::string describe(const parts::LabelledMesh& mesh,
                                 const parts::LabelledFaces& faces) {
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

TUMBLE_BODY std::string all_names(const parts::LabelledMesh& mesh) {
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
