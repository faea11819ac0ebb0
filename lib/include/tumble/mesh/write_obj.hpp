#pragma once
/// @file
/// Writes positions and faces as a Wavefront OBJ file, so that reading it gives the same bits.

#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>

#ifndef __wasi__
#include <fstream>
#endif

#include "tumble/core/require.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

/// Writes a mesh, with the 17 digits that tell any two doubles apart.
/// @param mesh indices in range, positions finite
inline void write_obj(std::ostream& out, const PolygonMesh& mesh) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  for (const Vec3& p : mesh.vertices) text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (int f = 0; f < mesh.face_count(); ++f) {
    text << 'f';
    for (const int v : mesh.face(f)) text << ' ' << v + 1;
    text << '\n';
  }
  out << text.str();
}

// wasi-libc++ has no file streams.
#ifndef __wasi__

/// Writes a mesh to a file.
/// @throws std::runtime_error when it cannot be written
inline void write_obj(const std::string& path, const PolygonMesh& mesh) {
  std::ofstream file(path);
  write_obj(file, mesh);
  file.close();
  if (!file) detail::throw_error<std::runtime_error>(path + ": cannot be written");
}

#endif

/// @}

}  // namespace tumble
