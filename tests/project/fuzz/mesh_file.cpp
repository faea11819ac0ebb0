/// @file
/// libFuzzer on mesh files: whatever the bytes, reading them ends, with a mesh or with words; and
/// what comes out is held against the laws of check_mesh.hpp.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "project/fuzz/check_mesh.hpp"
#include "tumble/mass/parts/mass_properties.hpp"
#include "tumble/mesh/parse_mesh.hpp"
#include "tumble/mesh/read_obj.hpp"

namespace {

using namespace tumble;

/// What comes of some bytes: a mesh, or the words of a refusal.
struct Reading {
  parts::LabelledMesh mesh;
  std::string words;
};

/// Every face is in one range, and every label in some.
void check_labels(const parts::LabelledMesh& mesh) {
  int end = 0;
  std::vector<bool> used(mesh.labels.size());
  for (const parts::LabelledFaces& faces : mesh.ranges) {
    fuzz::demand(faces.first == end && faces.end > end, "ranges follow each other");
    end = faces.end;
    used.at(static_cast<std::size_t>(faces.label)) = true;
  }
  fuzz::demand(end == mesh.face_count(), "up to the last face");
  fuzz::demand(std::find(used.begin(), used.end(), false) == used.end(), "labels are used");
}

/// Parts have mass properties, or are refused with words.
void check_parts(const parts::LabelledMesh& mesh) {
  parts::Densities densities;
  for (const parts::Label& label : mesh.labels)
    for (const std::string& name : {label.material, label.group, label.object})
      if (!name.empty() && densities.size() < 4) densities.emplace(name, 2);
  fuzz::refuses([&] { parts::mass_properties(mesh, densities); });
  fuzz::refuses([&] { parts::mass_properties(mesh, densities, {.policy = Policy::accept}); });
}

template <class Parse>
Reading read(std::string_view bytes, const Parse& parse) {
  Reading reading;
  try {
    reading.mesh = parts::LabelledMesh(parse(bytes, "fuzzed"));
  } catch (const std::invalid_argument& refusal) {
    reading.words = refusal.what();
    fuzz::demand(!reading.words.empty(), "a refusal has words");
    return reading;
  }
  fuzz::demand(reading.mesh.face_count() > 0, "a mesh that was read has faces");
  fuzz::demand(detail::find_bad_indices(reading.mesh).empty(), "and vertices that exist");
  fuzz::demand(detail::find_not_finite(reading.mesh).empty(), "and are finite");
  check_labels(reading.mesh);
  return reading;
}

/// An OBJ file read in blocks of a few bytes.
parts::LabelledMesh parse_in_blocks(std::string_view bytes, std::string_view name) {
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
  fuzz::demand(in_blocks.mesh.labels == whole.mesh.labels, "with the same names");
  fuzz::demand(in_blocks.mesh.ranges == whole.mesh.ranges, "of the same faces");
  fuzz::demand(in_blocks.words == whole.words, "and are refused with the same words");
  const parts::LabelledMesh mesh = read(bytes, parse_mesh).mesh;
  fuzz::check_mesh(mesh);
  check_parts(mesh);
  return 0;
}
