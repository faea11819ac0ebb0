/// @file
/// libFuzzer on mesh files: whatever the bytes, reading them ends, with a mesh or with words; and
/// what comes out is held against the laws of check_mesh.hpp.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "project/fuzz/check_mesh.hpp"
#include "tumble/mesh/parse_mesh.hpp"
#include "tumble/mesh/read_obj.hpp"

namespace {

using namespace tumble;

/// What comes of some bytes: a mesh, or the words of a refusal.
struct Reading {
  PolygonMesh mesh;
  std::string words;
};

template <class Parse>
Reading read(std::string_view bytes, const Parse& parse) {
  Reading reading;
  try {
    reading.mesh = parse(bytes, "fuzzed");
  } catch (const std::invalid_argument& refusal) {
    reading.words = refusal.what();
    fuzz::demand(!reading.words.empty(), "a refusal has words");
    return reading;
  }
  fuzz::demand(reading.mesh.face_count() > 0, "a mesh that was read has faces");
  fuzz::demand(detail::find_bad_indices(reading.mesh).empty(), "and vertices that exist");
  fuzz::demand(detail::find_not_finite(reading.mesh).empty(), "and are finite");
  return reading;
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
  read(bytes, detail::parse_stl);
  read(bytes, detail::parse_ply);
  const Reading whole = read(bytes, detail::parse_obj), in_blocks = read(bytes, parse_in_blocks);
  fuzz::demand(in_blocks.mesh.corners == whole.mesh.corners, "blocks are the whole");
  fuzz::demand(in_blocks.words == whole.words, "and are refused with the same words");
  fuzz::check_mesh(read(bytes, parse_mesh).mesh);
  return 0;
}
