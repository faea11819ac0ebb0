#include "project/bench/mass/reading.hpp"

#include <cmath>
#include <fstream>

#include "project/bench/least_times.hpp"
#include "project/harness/temporary_folder.hpp"
#include "project/library/mesh/mesh_files.hpp"
#include "project/library/mesh/shapes.hpp"
#include "support/text_file.hpp"
#include "tumble/mesh/read_mesh.hpp"

namespace tumble::bench {
namespace {

struct MeshFile {
  std::string what, path;
  double bytes;
};

std::vector<MeshFile> write_files(const PolygonMesh& mesh, const std::filesystem::path& folder) {
  std::vector<MeshFile> files;
  const auto add = [&](const std::string& what, const std::string& name, const std::string& bytes) {
    const std::string path = (folder / name).string();
    support::write_text(path, bytes);
    files.push_back({what, path, static_cast<double>(bytes.size())});
  };
  add("OBJ", "plain.obj", test::plain_obj(mesh));
  add("OBJ, 100 faces a group", "named.obj", test::named_obj(mesh));
  add("OBJ, v/vt/vn", "full.obj", test::full_obj(mesh));
  add("STL, binary", "binary.stl", test::binary_stl(mesh));
  add("STL, ASCII", "ascii.stl", test::text_stl(mesh));
  add("PLY, binary", "binary.ply", test::binary_ply(mesh));
  add("PLY, ASCII", "ascii.ply", test::text_ply(mesh));
  return files;
}

/// Reads the bytes, a block at a time: what no reader can be faster than.
double read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string block(1 << 17, '\0');
  double sum = 0;
  while (file) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    sum += static_cast<double>(file.gcount());
  }
  return sum;
}

std::vector<Reader> readers(bool with_peers) {
  std::vector<Reader> all = {
      {"tumble", [](const std::string& path) { return double(read_mesh(path).face_count()); }}};
#ifdef TUMBLE_HAS_TINYOBJLOADER
  if (with_peers) add_tinyobjloader(all);
#endif
  static_cast<void>(with_peers);
  all.push_back({"its bytes alone", read_bytes});
  return all;
}

struct Reading {
  const MeshFile* file;
  const Reader* reader;
  double seconds = 0;  ///< the least
};

/// What reads what; each has read it once, and found all faces.
std::vector<Reading> readings_of(const std::vector<MeshFile>& files,
                                 const std::vector<Reader>& readers, int faces) {
  std::vector<Reading> readings;
  for (const MeshFile& file : files)
    for (const Reader& reader : readers) {
      if (reader.only_obj && !file.path.ends_with(".obj")) continue;
      const double found = reader.read(file.path);
      require(found == faces || found == file.bytes, reader.name, " finds ", found, " faces in ",
              file.path);
      readings.push_back({&file, &reader});
    }
  return readings;
}

void measure(std::vector<Reading>& readings, int repetitions, double seconds) {
  std::vector<Timed> timed;
  for (const Reading& r : readings)
    timed.push_back({[&r] { return r.reader->read(r.file->path); }, repetitions, seconds});
  const std::vector<double> least = least_times(timed);
  for (std::size_t i = 0; i < readings.size(); ++i) readings[i].seconds = least[i];
}

support::Table table_of(const std::vector<Reading>& readings, int faces) {
  support::Table table({"file", "MB", "read by", "ns per triangle", "MB/s", "× tumble"});
  double own = 1;
  for (const Reading& r : readings) {
    if (r.reader->name == "tumble") own = r.seconds;
    table.add({r.file->what, support::number(r.file->bytes / 1e6, 3), r.reader->name,
               support::number(r.seconds * 1e9 / faces, 3),
               support::number(r.file->bytes / 1e6 / r.seconds, 3),
               support::number(r.seconds / own, 2)});
  }
  return table;
}

}  // namespace

support::Table reading_table(int triangles, int repetitions, double seconds, bool with_peers) {
  const int tube = static_cast<int>(std::lround(std::sqrt(triangles / 4.0)));
  const PolygonMesh torus = test::triangulated(test::torus(2 * tube, tube));
  const test::TemporaryFolder folder;
  const std::vector<MeshFile> files = write_files(torus, folder.path());
  const std::vector<Reader> all = readers(with_peers);
  std::vector<Reading> readings = readings_of(files, all, torus.face_count());
  measure(readings, repetitions, seconds);
  return table_of(readings, torus.face_count());
}

}  // namespace tumble::bench
