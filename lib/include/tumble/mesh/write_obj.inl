#pragma once

#include "tumble/mesh/write_obj.hpp"

#ifndef __wasi__
#include <fstream>
#endif
#include <limits>
#include <sstream>
#include <stdexcept>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble {

TUMBLE_BODY void write_obj(std::ostream& out, const PolygonMesh& mesh) {
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

#ifndef __wasi__
TUMBLE_BODY void write_obj(const std::string& path, const PolygonMesh& mesh) {
  std::ofstream file(path);
  write_obj(file, mesh);
  file.close();
  if (!file) detail::throw_error<std::runtime_error>(path + ": cannot be written");
}
#endif

}  // namespace tumble
