#pragma once
/// @file
/// The files of a student that are given in a folder, or in a zip as it was handed in.

#include <functional>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// The file of a unit in a folder of files: DIR/04_quaternions/product.cpp or DIR/product.cpp.
fs::path file_in(const fs::path& folder, const Unit& unit);

/// Whether it is an archive, which has to be unpacked.
bool is_archive(const fs::path& given);

/// What `--from` names.
class GivenFiles {
 public:
  /// @throws std::invalid_argument if an archive cannot be read: why
  GivenFiles(const Course& course, const fs::path& from);
  fs::path of(const Unit& unit) const { return file_of_(unit); }

 private:
  std::function<fs::path(const Unit&)> file_of_;
};

}  // namespace tumble::judge
