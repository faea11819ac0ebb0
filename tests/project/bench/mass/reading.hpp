#pragma once
/// @file
/// How long mesh files take to read: every format, beside other software where it is installed.

#include <functional>
#include <string>
#include <vector>

#include "support/table.hpp"

namespace tumble::bench {

/// A way to read a mesh file.
struct Reader {
  std::string name;
  std::function<double(const std::string&)> read;  ///< of a path; gives the number of faces
  bool only_obj = false;
};

/// Other software's, where it is installed.
void add_tinyobjloader(std::vector<Reader>& readers);

/// A torus of triangles, written in each format into a folder of its own, and read again.
/// @param repetitions  of which the least time counts
/// @param seconds      of each repetition, at least
/// @throws std::invalid_argument if a reader finds another number of faces
support::Table reading_table(int triangles, int repetitions, double seconds, bool with_peers);

}  // namespace tumble::bench
