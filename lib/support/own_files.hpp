#pragma once
/// @file
/// Files that a program is about to write: none of them may be one that it reads, or another one of
/// them. A mistyped name must not cost you a file.

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "tumble/core/require.hpp"

namespace tumble::support {

/// A file, and what it is to the program: "--csv", "your scene".
struct NamedFile {
  std::string role;
  std::filesystem::path path;
};

/// Whether what is written to one of them would be lost in the other: a device or a pipe keeps
/// nothing, and takes several texts one after the other.
inline bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  namespace fs = std::filesystem;
  std::error_code missing;
  if (fs::equivalent(a, b, missing)) return fs::is_regular_file(a, missing);
  if (fs::exists(a, missing) || fs::exists(b, missing)) return false;
  const auto where = [&](const fs::path& path) {
    return fs::weakly_canonical(fs::absolute(path), missing);  // a folder may be named by a link
  };
  return where(a) == where(b);
}

/// @param outputs those without a path are not asked for
/// @throws std::invalid_argument that names the two
inline void require_own_files(const std::vector<NamedFile>& inputs,
                              const std::vector<NamedFile>& outputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->path.empty()) continue;
    for (const NamedFile& input : inputs)
      require(!is_same_file(input.path, output->path), output->role, ' ', output->path.string(),
              ": this file is ", input.role, ", and we would overwrite it. Give another name");
    for (auto before = outputs.begin(); before != output; ++before)
      require(before->path.empty() || !is_same_file(before->path, output->path), before->role,
              " and ", output->role, " name the same file, ", output->path.string(),
              ": only one of the two would be left. Give each its own name");
  }
}

}  // namespace tumble::support
