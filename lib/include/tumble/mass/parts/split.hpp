#pragma once
/// @file
/// The parts of a mesh whose file names its faces: one for each name that has a density.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/mesh/labelled_mesh.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

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

void require_names(const parts::LabelledMesh& mesh, const parts::Densities& densities);

/// The one name with a density that some faces are in.
/// @throws std::invalid_argument if there is none, or there are two
std::string part_of(const parts::LabelledMesh& mesh, const parts::LabelledFaces& faces,
                    const parts::Densities& densities);

/// The part of each label.
std::vector<std::string> parts_of_labels(const parts::LabelledMesh& mesh,
                                         const parts::Densities& densities);

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
std::vector<Part> split(const LabelledMesh& mesh, const Densities& densities);

/// @}

}  // namespace tumble::parts

#ifndef TUMBLE_COMPILED
#include "tumble/mass/parts/split.inl"
#endif
