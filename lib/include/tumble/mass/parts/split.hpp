#pragma once
/// @file
/// The parts of a mesh whose file names its faces: one for each name that has a density.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/mass/parts/label_names.hpp"
#include "tumble/mass/require_density.hpp"
#include "tumble/mesh/check_faces.hpp"

namespace tumble::parts {

/// @addtogroup mass
/// @{

/// Densities [kg/m³], each for all faces that are in the material, the group or the object of a
/// name.
using Densities = std::map<std::string, double>;

/// What has one density.
struct Part {
  std::string name;
  double density = 1;         ///< [kg/m³]
  PolygonMesh mesh;           ///< its faces, and the vertices that they use [m]
  std::vector<int> faces;     ///< which faces of the whole mesh they are, from 0
  std::vector<int> vertices;  ///< which vertices of the whole mesh they are, from 0
};

/// @}

}  // namespace tumble::parts

namespace tumble::detail {

inline void require_names(const parts::LabelledMesh& mesh, const parts::Densities& densities) {
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

/// The one name with a density that some faces are in.
/// @throws std::invalid_argument if there is none, or there are two
inline std::string part_of(const parts::LabelledMesh& mesh, const parts::LabelledFaces& faces,
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

/// The part of each label.
inline std::vector<std::string> parts_of_labels(const parts::LabelledMesh& mesh,
                                                const parts::Densities& densities) {
  std::vector<std::string> result(mesh.labels.size());
  for (const parts::LabelledFaces& faces : mesh.ranges)
    if (std::string& part = result[static_cast<std::size_t>(faces.label)]; part.empty())
      part = part_of(mesh, faces, densities);
  return result;
}

/// Copies faces of a mesh into parts, whose vertices get numbers of their own, in the same order.
class PartFiller {
 public:
  explicit PartFiller(const PolygonMesh& mesh) : mesh_(mesh), vertices_(mesh.vertices.size()) {}

  /// Fills an empty part.
  void fill(parts::Part& part, const std::vector<parts::LabelledFaces>& faces) {
    for (const parts::LabelledFaces& range : faces)
      for (int f = range.first; f < range.end; ++f) {
        part.faces.push_back(f);
        for (const int v : mesh_.face(f)) note_vertex(part, v);
      }
    std::sort(part.vertices.begin(), part.vertices.end());
    for (const int v : part.vertices) {
      copy_of(v).vertex = static_cast<int>(part.mesh.vertices.size());
      part.mesh.vertices.push_back(mesh_.vertex(v));
    }
    for (const int f : part.faces) {
      for (const int v : mesh_.face(f)) part.mesh.corners.push_back(copy_of(v).vertex);
      part.mesh.first_corner.push_back(static_cast<int>(part.mesh.corners.size()));
    }
  }

 private:
  struct Copy {
    const parts::Part* in = nullptr;  ///< the last part that the vertex was copied into
    int vertex = -1;                  ///< which vertex of it
  };

  Copy& copy_of(int v) { return vertices_[static_cast<std::size_t>(v)]; }

  void note_vertex(parts::Part& part, int v) {
    if (copy_of(v).in == &part) return;
    copy_of(v).in = &part;
    part.vertices.push_back(v);
  }

  const PolygonMesh& mesh_;
  std::vector<Copy> vertices_;
};

}  // namespace tumble::detail

namespace tumble::parts {

/// @addtogroup mass
/// @{

/// Divides a mesh into parts, in the order in which they begin in the file.
/// @param densities of all faces, by name; a face may have several names, and one density
/// @throws std::invalid_argument if a density is not positive and finite, no face is in a name, or
///         faces have no density or two: the message gives the name or the faces, and the names
///         that there are
inline std::vector<Part> split(const LabelledMesh& mesh, const Densities& densities) {
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

/// @}

}  // namespace tumble::parts
