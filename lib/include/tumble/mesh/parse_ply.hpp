#pragma once
/// @file
/// The vertices and faces of a PLY file in memory, ASCII or binary.
///
/// Source: G. Turk, The PLY polygon file format, Stanford 1994.

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tumble/mesh/ply_header.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::detail {
/// Reads all elements, and makes a mesh of those called vertex and face.
/// @tparam Values PlyText or PlyBytes
template <class Values>
class PlyBodyReader {
 public:
  PlyBodyReader(const PlyHeader& header, Values values, std::string_view name)
      : header_(header), values_(std::move(values)), name_(name) {}

  PolygonMesh read() {
    require(has("vertex"), name_, ": no element 'vertex' among ", element_names());
    for (const PlyElement& element : header_.elements) {
      require(element.count == 0 || !element.properties.empty(), name_, ": the element '",
              shown(element.name), "' has no properties");
      if (element.count > 0) read_all(element);
    }
    values_.require_end();
    require(count_of("tristrips") == 0, name_,
            ": part of the surface is in strips of triangles ('tristrips'), which are not read");
    require(mesh_.face_count() > 0, name_, ": no faces (", mesh_.vertices.size(), " vertices)",
            has("face") ? "" : ": no element 'face' among " + element_names());
    return std::move(mesh_);
  }

 private:
  void read_all(const PlyElement& element) {
    values_.require_room(element);
    if (element.name == "vertex")
      read_vertices(element);
    else if (element.name == "face")
      read_faces(element);
    else
      for_each(element, [&] {
        for (const PlyProperty& property : element.properties) skip(property);
      });
  }

  template <class Read>
  void for_each(const PlyElement& element, const Read& read) {
    for (std::int64_t i = 0; i < element.count; ++i) {
      values_.begin(element, i);
      read();
      values_.end();
    }
  }

  void read_vertices(const PlyElement& element) {
    require(element.count <= std::numeric_limits<int>::max(), name_, ": ", element.count,
            " vertices are more than a mesh holds");
    const std::vector<int> axes = axes_of(element);
    mesh_.vertices.reserve(static_cast<std::size_t>(element.count));
    for_each(element, [&] {
      Vec3 p = Vec3::Zero();
      for (std::size_t i = 0; i < axes.size(); ++i)
        if (axes[i] < 0)
          skip(element.properties[i]);
        else
          p[axes[i]] = read_coordinate(element.properties[i]);
      mesh_.vertices.push_back(p);
    });
  }

  /// For each property 0, 1 or 2, or −1 if it is not a coordinate.
  std::vector<int> axes_of(const PlyElement& element) const {
    std::vector<int> axes(element.properties.size(), -1);
    for (int k = 0; k < 3; ++k) {
      const std::string_view axis = std::string_view("xyz").substr(static_cast<std::size_t>(k), 1);
      const std::size_t i = find(element, axis);
      require(i < axes.size() && !element.properties[i].count, name_,
              ": a vertex has no coordinate '", axis, "'");
      axes[i] = k;
    }
    return axes;
  }

  static std::size_t find(const PlyElement& element, std::string_view name) {
    std::size_t i = 0;
    while (i < element.properties.size() && element.properties[i].name != name) ++i;
    return i;
  }

  double read_coordinate(const PlyProperty& property) {
    const double x = values_.next(property, property.type);
    if (!std::isfinite(x))
      values_.refuse("has ", x, " for '", property.name, "', which is not a finite number");
    return x;
  }

  void read_faces(const PlyElement& element) {
    const std::size_t count = element.properties.size();
    const std::size_t list =
        std::min(find(element, "vertex_indices"), find(element, "vertex_index"));
    require(list < count && element.properties[list].count, name_,
            ": a face has no list 'vertex_indices'");
    mesh_.corners.reserve(3 * static_cast<std::size_t>(element.count));
    mesh_.first_corner.reserve(static_cast<std::size_t>(element.count) + 1);
    for_each(element, [&] {
      for (std::size_t i = 0; i < count; ++i)
        if (i == list)
          read_face(element.properties[i]);
        else
          skip(element.properties[i]);
    });
  }

  void read_face(const PlyProperty& property) {
    const std::int64_t count = read_length(property);
    if (count < 3) values_.refuse("has ", count, " corners, and needs 3");
    for (std::int64_t k = 0; k < count; ++k) {
      const std::int64_t v = read_whole(property, property.type);
      if (v < 0 || v >= vertex_count_)
        values_.refuse("has vertex ", v, ", but there are ", vertex_count_, " vertices, from 0");
      mesh_.corners.push_back(static_cast<int>(v));
    }
    if (mesh_.corners.size() > std::numeric_limits<int>::max())
      values_.refuse("is one too many: a mesh has at most 2147483647 corners");
    mesh_.first_corner.push_back(static_cast<int>(mesh_.corners.size()));
  }

  std::int64_t read_length(const PlyProperty& property) {
    const std::int64_t count = read_whole(property, *property.count);
    if (count < 0) values_.refuse("has a list '", shown(property.name), "' of ", count, " values");
    return count;
  }

  /// A length or the number of a vertex. Some programs write them as floats: those count as long as
  /// no other whole number is rounded to the same one.
  std::int64_t read_whole(const PlyProperty& property, PlyType type) {
    const double x = values_.next(property, type);
    if (!(std::abs(x) < (type == PlyType::float32 ? 0x1p24 : 0x1p53) && x == std::floor(x)))
      values_.refuse("has ", x, " for '", shown(property.name),
                     "', which is not a whole number that ", about(type).name, " holds for sure");
    return static_cast<std::int64_t>(x);
  }

  void skip(const PlyProperty& property) {
    values_.skip(property, property.type, property.count ? read_length(property) : 1);
  }

  bool has(std::string_view name) const {
    return std::any_of(header_.elements.begin(), header_.elements.end(),
                       [&](const PlyElement& element) { return element.name == name; });
  }

  /// "'Vertex', 'face'": a name in another spelling is another name.
  std::string element_names() const {
    std::string names;
    for (const PlyElement& element : header_.elements)
      names += (names.empty() ? "'" : ", '") + shown(element.name) + "'";
    return names.empty() ? "none" : names;
  }

  std::int64_t count_of(std::string_view name) const {
    for (const PlyElement& element : header_.elements)
      if (element.name == name) return element.count;
    return 0;
  }

  const PlyHeader& header_;
  Values values_;
  std::string_view name_;
  std::int64_t vertex_count_ = count_of("vertex");
  PolygonMesh mesh_;
};

/// Reads a PLY file. Polygons stay polygons; vertices that no face uses, and equal ones, stay.
/// Elements and properties other than the vertices' x, y, z [m] and the faces' vertex_indices (or
/// vertex_index) are passed over, in any order and of any type; lengths and vertices' numbers may
/// be whole numbers of any type.
/// @param bytes of the file: ascii, binary_little_endian or binary_big_endian 1.0
/// @param name  what the file is called in messages
/// @throws std::invalid_argument naming the line or the byte, and the element, for: a header that
///         is not one of PLY, a file that is shorter or longer than its elements, a coordinate that
///         is not a finite number, a face of fewer than 3 corners, a vertex that is not there, no
///         faces
PolygonMesh parse_ply(std::string_view bytes, std::string_view name);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/parse_ply.inl"
#endif
