#pragma once
/// @file
/// One grading at a time in a folder: two would do the same work, and write the same files.

#include <filesystem>

#include "judge/sandbox/pipe.hpp"

namespace tumble::judge {

/// Holds a folder's lock while it lives. The system takes it away from a process that is killed.
class GradingLock {
 public:
  /// @throws std::invalid_argument if another process holds it
  explicit GradingLock(const std::filesystem::path& file);

 private:
  Descriptor file_;
};

}  // namespace tumble::judge
