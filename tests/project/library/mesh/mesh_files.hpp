#pragma once
/// @file
/// Meshes as files of each format: what readers are tried on, and timed with.

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <string>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::test {

/// The bytes of an integer, the lowest one first or last.
template <std::unsigned_integral T>
std::string bytes_of(T value, bool lowest_first = true) {
  std::string bytes;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t place = lowest_first ? i : sizeof(T) - 1 - i;
    bytes += static_cast<char>(value >> (8 * place) & 0xFF);
  }
  return bytes;
}
inline std::string bytes_of(float value, bool lowest_first = true) {
  return bytes_of(std::bit_cast<std::uint32_t>(value), lowest_first);
}
inline std::string bytes_of(double value, bool lowest_first = true) {
  return bytes_of(std::bit_cast<std::uint64_t>(value), lowest_first);
}

/// Three numbers with 6 digits after the point, as most programs write them.
inline std::string numbers_of(const Vec3& p) {
  char text[128];
  const int length = std::snprintf(text, sizeof text, "%.6f %.6f %.6f", p.x(), p.y(), p.z());
  return std::string(text, static_cast<std::size_t>(length));
}

/// @param index what stands for vertex v in a face: "7" or "7/7/7"
template <class Index>
std::string obj_file(const PolygonMesh& mesh, const std::string& more_per_vertex,
                     const Index& index) {
  std::string text;
  for (const Vec3& p : mesh.vertices) text += "v " + numbers_of(p) + '\n' + more_per_vertex;
  for (int f = 0; f < mesh.face_count(); ++f) {
    text += 'f';
    for (const int v : mesh.face(f)) text += ' ' + index(std::to_string(v + 1));
    text += '\n';
  }
  return text;
}

inline std::string plain_obj(const PolygonMesh& mesh) {
  return obj_file(mesh, "", [](const std::string& v) { return v; });
}

/// With a group and a material for every hundred faces.
inline std::string named_obj(const PolygonMesh& mesh) {
  const std::string plain = plain_obj(mesh);
  std::string text;
  int face = 0;
  for (std::size_t begin = 0; begin < plain.size();) {
    const std::size_t end = plain.find('\n', begin) + 1;
    if (const int part = face / 100; plain[begin] == 'f' && face++ % 100 == 0)
      text +=
          "g part" + std::to_string(part) + "\nusemtl material" + std::to_string(part % 7) + '\n';
    text += plain.substr(begin, end - begin);
    begin = end;
  }
  return text;
}

/// With a texture and a normal for each vertex.
inline std::string full_obj(const PolygonMesh& mesh) {
  return obj_file(mesh, "vt 0.250000 0.750000\nvn 0.000000 0.600000 -0.800000\n",
                  [](const std::string& v) { return v + '/' + v + '/' + v; });
}

/// @param mesh of triangles
inline std::string text_stl(const PolygonMesh& mesh) {
  std::string text = "solid made for a test\n";
  for (int f = 0; f < mesh.face_count(); ++f) {
    text += "facet normal 0.0 0.0 1.0\nouter loop\n";
    for (const int v : mesh.face(f)) text += "vertex " + numbers_of(mesh.vertex(v)) + '\n';
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid made for a test\n";
}

/// @param mesh   of triangles
/// @param header of which 80 bytes are taken
inline std::string binary_stl(const PolygonMesh& mesh, std::string header = "made for a test") {
  header.resize(80, ' ');
  std::string file = header + bytes_of(static_cast<std::uint32_t>(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int k = 0; k < 3; ++k) file += bytes_of(0.0F);
    for (const int v : mesh.face(f))
      for (int k = 0; k < 3; ++k) file += bytes_of(static_cast<float>(mesh.vertex(v)[k]));
    file += std::string(2, '\0');
  }
  return file;
}

/// Coordinates in double precision.
/// @param format ascii, binary_little_endian, binary_big_endian
inline std::string ply_header(const PolygonMesh& mesh, const std::string& format) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(mesh.face_count()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string text_ply(const PolygonMesh& mesh) {
  std::string text = ply_header(mesh, "ascii");
  for (const Vec3& p : mesh.vertices) text += numbers_of(p) + '\n';
  for (int f = 0; f < mesh.face_count(); ++f) {
    text += std::to_string(mesh.face(f).size());
    for (const int v : mesh.face(f)) text += ' ' + std::to_string(v);
    text += '\n';
  }
  return text;
}

inline std::string binary_ply(const PolygonMesh& mesh, bool little = true) {
  std::string file = ply_header(mesh, little ? "binary_little_endian" : "binary_big_endian");
  for (const Vec3& p : mesh.vertices)
    for (int k = 0; k < 3; ++k) file += bytes_of(p[k], little);
  for (int f = 0; f < mesh.face_count(); ++f) {
    file += static_cast<char>(mesh.face(f).size());
    for (const int v : mesh.face(f)) file += bytes_of(static_cast<std::uint32_t>(v), little);
  }
  return file;
}

}  // namespace tumble::test
