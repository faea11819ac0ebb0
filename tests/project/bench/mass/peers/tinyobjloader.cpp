// tinyobjloader: faces stay polygons, as with us.
#include <tiny_obj_loader.h>

#include "project/bench/mass/reading.hpp"
#include "tumble/core/require.hpp"

namespace tumble::bench {
namespace {

double read(const std::string& path) {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  const bool good = tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error,
                                     path.c_str(), nullptr, false);
  require(good, path, ": ", error);
  double faces = 0;
  for (const tinyobj::shape_t& shape : shapes)
    faces += static_cast<double>(shape.mesh.num_face_vertices.size());
  return faces;
}

}  // namespace

void add_tinyobjloader(std::vector<Reader>& readers) {
  readers.push_back({"tinyobjloader", read, true});
}

}  // namespace tumble::bench
