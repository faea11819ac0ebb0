/// @file
/// libFuzzer on mesh files: whatever the bytes, reading them ends, with a mesh or with words; and
/// what comes out is held against the laws of check_mesh.hpp.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "fuzz/check_mesh.hpp"
#include "tumble/mesh/parse_mesh.hpp"
#include "tumble/mesh/read_obj.hpp"

namespace {

using namespace tumble;

template <class Parse>
PolygonMesh read(std::string_view bytes, const Parse& parse) {
  PolygonMesh mesh;
  fuzz::refuses([&] {
    mesh = parse(bytes, "fuzzed");
    fuzz::demand(mesh.face_count() > 0, "a mesh that was read has faces");
    fuzz::demand(find_bad_indices(mesh).empty(), "and vertices that exist");
    fuzz::demand(find_not_finite(mesh).empty(), "and are finite");
  });
  return mesh;
}

/// An OBJ file read in blocks of a few bytes.
PolygonMesh parse_in_blocks(std::string_view bytes, std::string_view name) {
  std::istringstream stream{std::string(bytes)};
  std::optional<detail::ObjReader> reader;
  detail::for_each_block_of_lines(stream, 7, [&](std::string_view block) {
    if (reader)
      reader->read(block);
    else
      reader.emplace(block, name);
  });
  return reader->mesh();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  read(bytes, parse_stl);
  read(bytes, parse_ply);
  const PolygonMesh obj = read(bytes, parse_obj);
  fuzz::demand(read(bytes, parse_in_blocks).corners == obj.corners, "blocks are the whole");
  fuzz::check_mesh(read(bytes, parse_mesh));
  return 0;
}
