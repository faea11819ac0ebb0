#pragma once

#include "tumble/mesh/read_file.hpp"

#include <algorithm>
#include <stdexcept>
#ifndef __wasi__
#include <system_error>
#endif

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble::detail {

TUMBLE_BODY std::size_t size_of(std::istream& file) {
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::streamoff>(file.tellg());
  file.clear();
  file.seekg(0);
  file.clear();
  return size > 0 ? static_cast<std::size_t>(size) : 0;
}

TUMBLE_BODY std::string read_all(std::istream& in, std::size_t size, const std::string& name) {
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
TUMBLE_BODY std::ifstream open_file(const std::string& path) {
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
#endif

}  // namespace tumble::detail
