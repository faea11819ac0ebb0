#pragma once
/// @file
/// Opens a file, and reads all bytes of it. For wasm32-wasi there are streams, and no files.

#ifndef __wasi__
#include <cerrno>
#include <fstream>
#endif
#include <istream>
#include <string>

namespace tumble::detail {

/// The length of a file from its beginning [bytes]; 0 where that is not known, as in a pipe.
std::size_t size_of(std::istream& file);

/// What is left of a stream.
/// @param size what it is thought to be [bytes]
/// @throws std::runtime_error when the stream fails
std::string read_all(std::istream& in, std::size_t size, const std::string& name);

#ifndef __wasi__
/// @throws std::runtime_error when the file cannot be read, with the system's reason
std::ifstream open_file(const std::string& path);

/// All bytes of a file.
/// @throws std::runtime_error when the file cannot be read
inline std::string read_file(const std::string& path) {
  std::ifstream file = open_file(path);
  return read_all(file, size_of(file), path);
}

#endif

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/read_file.inl"
#endif
