#pragma once
/// @file
/// Opens a file, and reads all bytes of it. For wasm32-wasi there are streams, and no files.

#include <algorithm>
#ifndef __wasi__
#include <cerrno>
#include <fstream>
#include <system_error>
#endif
#include <istream>
#include <stdexcept>
#include <string>

#include "tumble/core/require.hpp"

namespace tumble::detail {

/// The length of a file from its beginning [bytes]; 0 where that is not known, as in a pipe.
inline std::size_t size_of(std::istream& file) {
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::streamoff>(file.tellg());
  file.clear();
  file.seekg(0);
  file.clear();
  return size > 0 ? static_cast<std::size_t>(size) : 0;
}

/// What is left of a stream.
/// @param size what it is thought to be [bytes]
/// @throws std::runtime_error when the stream fails
inline std::string read_all(std::istream& in, std::size_t size, const std::string& name) {
  std::string bytes;
  std::size_t step = std::max<std::size_t>(size + 1, 1 << 16);
  while (in) {
    const std::size_t before = bytes.size();
    bytes.resize(before + step);
    in.read(bytes.data() + before, static_cast<std::streamsize>(step));
    bytes.resize(before + static_cast<std::size_t>(in.gcount()));
    step = bytes.size();
  }
  if (in.bad()) detail::throw_error<std::runtime_error>(name + ": cannot be read");
  return bytes;
}

#ifndef __wasi__
/// @throws std::runtime_error when the file cannot be read, with the system's reason
inline std::ifstream open_file(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (file.is_open()) file.peek();  // a directory can be opened, but not read
  if (!file.is_open() || file.bad())
    detail::throw_error<std::runtime_error>(
        path + ": cannot be read" +
        (errno != 0 ? " (" + std::generic_category().message(errno) + ")" : ""));
  file.clear();
  return file;
}

/// All bytes of a file.
/// @throws std::runtime_error when the file cannot be read
inline std::string read_file(const std::string& path) {
  std::ifstream file = open_file(path);
  return read_all(file, size_of(file), path);
}

#endif

}  // namespace tumble::detail
