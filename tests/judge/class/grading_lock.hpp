#pragma once
/// @file
/// One grading at a time in a folder: two would do the same work, and write the same files. Shards
/// of a class do neither, and may be at work beside each other.

#include <filesystem>
#include <string>

#include "judge/sandbox/pipe.hpp"

namespace tumble::judge {

/// Holds a folder's lock while it lives. The system takes it away from a process that is killed.
class GradingLock {
 public:
  enum class With { nobody, other_shards };

  /// Where the file system has no locks, nothing is held, and that is said.
  /// @param where what is locked, for the message
  /// @throws std::invalid_argument if another process holds it
  GradingLock(const std::filesystem::path& file, const std::string& where,
              With with = With::nobody);

 private:
  Descriptor file_;
};

}  // namespace tumble::judge
