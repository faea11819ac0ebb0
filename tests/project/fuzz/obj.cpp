/// @file
/// libFuzzer on mesh files: whatever the bytes, reading them ends, with a mesh or with words; and
/// what comes out is held against the laws of check_mesh.hpp.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include "project/fuzz/check_mesh.hpp"
#include "tumble/mesh/read_obj.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tumble;
  std::istringstream file(std::string(reinterpret_cast<const char*>(data), size));
  PolygonMesh mesh;
  fuzz::refuses([&] {
    mesh = read_obj(file, "fuzzed.obj");
    fuzz::demand(mesh.face_count() > 0, "a mesh that was read has faces");
    fuzz::demand(find_bad_indices(mesh).empty(), "and vertices that exist");
    fuzz::demand(find_not_finite(mesh).empty(), "and are finite");
  });
  fuzz::check_mesh(mesh);
  return 0;
}
