#pragma once
/// @file
/// A folder for one run of the judge, gone at its end.

#include <filesystem>

namespace tumble::judge {

class WorkFolder {
 public:
  /// Makes the folder, and removes those that killed judges have left behind.
  /// @throws std::runtime_error if there is no place for it
  WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tumble::judge
