#pragma once
/// @file
/// The files that a confined program may open, kept by the kernel (Landlock).

#include "judge/sandbox/walls.hpp"

namespace tumble::judge {

/// A set of rules, ready to be put on a process.
class FileRules {
 public:
  /// Rules that allow `files` and nothing else. Paths that do not exist are left out.
  explicit FileRules(const OpenFiles& files);
  FileRules(const FileRules&) = delete;
  FileRules& operator=(const FileRules&) = delete;
  ~FileRules();
  /// Puts this process behind the rules. Async-signal-safe.
  bool install() const;

 private:
  int rules_ = -1;
};

/// Whether this kernel has such rules; if not, FileRules does nothing.
bool file_rules_available();

}  // namespace tumble::judge
