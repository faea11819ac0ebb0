#pragma once

#include "tumble/mass/parts/split.hpp"

#include <set>

#include "tumble/core/compiled.hpp"
#include "tumble/mass/parts/label_names.hpp"
#include "tumble/mass/require_density.hpp"
#include "tumble/mesh/check_faces.hpp"

namespace tumble::detail {

TUMBLE_BODY void require_names(const parts::LabelledMesh& mesh, const parts::Densities& densities) {
  require(!densities.empty(), "there are no densities");
  std::set<std::string> names;
  for (const parts::Label& label : mesh.labels)
    for (const std::string& name : names_of(label)) names.insert(name);
  require(!names.empty(),
          "no face has a name; faces get them from lines with usemtl, g or o of an "
          "OBJ file");
  for (const auto& [name, density] : densities) {
    require_at([rho = density] { require_density(rho); }, "the part \"", name, "\": ");
    require(names.contains(name), "no face is in \"", name, "\": there are ", all_names(mesh));
  }
}

TUMBLE_BODY std::string part_of(const parts::LabelledMesh& mesh, const parts::LabelledFaces& faces,
                                const parts::Densities& densities) {
  std::string part;
  for (const std::string& name : names_of(mesh.labels[static_cast<std::size_t>(faces.label)])) {
    if (name == part || !densities.contains(name)) continue;
    require(part.empty(), describe(mesh, faces), " have two densities, as \"", part, "\" and as \"",
            name, "\": give one of them");
    part = name;
  }
  require(!part.empty(), describe(mesh, faces), " have no density: there are ", all_names(mesh));
  return part;
}

TUMBLE_BODY std::vector<std::string> parts_of_labels(const parts::LabelledMesh& mesh,
                                                     const parts::Densities& densities) {
  std::vector<std::string> result(mesh.labels.size());
  for (const parts::LabelledFaces& faces : mesh.ranges)
    if (std::string& part = result[static_cast<std::size_t>(faces.label)]; part.empty())
      part = part_of(mesh, faces, densities);
  return result;
}

}  // namespace tumble::detail

namespace tumble::parts {

TUMBLE_BODY std::vector<Part> split(const LabelledMesh& mesh, const Densities& densities) {
  for (const MeshDefect& bad : detail::find_bad_indices(mesh)) require(false, bad.message);
  detail::require_names(mesh, densities);
  const std::vector<std::string> part_of_label = detail::parts_of_labels(mesh, densities);
  std::vector<Part> parts;
  std::map<std::string, std::vector<LabelledFaces>> faces;
  for (const LabelledFaces& range : mesh.ranges) {
    const std::string& name = part_of_label[static_cast<std::size_t>(range.label)];
    std::vector<LabelledFaces>& of_part = faces[name];
    if (of_part.empty()) parts.push_back({name, densities.at(name), {}, {}, {}});
    of_part.push_back(range);
  }
  detail::PartFiller filler(mesh);
  for (Part& part : parts) filler.fill(part, faces[part.name]);
  return parts;
}

}  // namespace tumble::parts
