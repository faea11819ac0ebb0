#pragma once
/// @file
/// Text into a file, or a refusal.

#include <fstream>
#include <string>

#include "tumble/core/require.hpp"

namespace tumble::bench {

/// @throws std::invalid_argument if the file cannot be written
inline void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  require(bool(file.flush()), "cannot write ", path);
}

}  // namespace tumble::bench
