#pragma once
/// @file
/// The compiler behind its walls, working in one folder.

#include <filesystem>
#include <string>
#include <vector>

#include "judge/course/course.hpp"
#include "judge/sandbox/confined_process.hpp"
#include "judge/sandbox/worker_program.hpp"

namespace tumble::judge {

using Arguments = std::vector<std::string>;

Limits compiler_limits();

/// Whether a judge that root has started can run the compiler as another user, too: not if other
/// users may not enter the course's folders.
bool others_may_compile(const Course& course);

class ConfinedCompiler {
 public:
  /// @param folder made here; the only place where the compiler can write
  /// @param reads  what it may read beside the system's headers and libraries
  ConfinedCompiler(const Course& course, fs::path folder, const std::vector<fs::path>& reads);

  const fs::path& folder() const { return folder_; }
  /// The folder, and these files in it, belong to the user that the compiler runs as.
  void hand_over(const std::vector<fs::path>& files) const;
  Finished run(const Arguments& arguments) const;
  /// The functions that an object defines, as they are declared: "quaternions::prod(double)".
  /// Nothing where there is no nm (binutils, which a compiler needs anyway).
  std::vector<std::string> functions_in(const fs::path& object) const;

 private:
  const Toolchain& tools_;
  fs::path folder_;
  Walls walls_;
};

/// Whether a step of the compiler was stopped by its limits.
bool ran_into_limits(const Finished& step);

/// A worker that the linker has left in `folder`, ready to be started behind all walls.
WorkerProgram confined_worker(const fs::path& folder, const fs::path& worker);

}  // namespace tumble::judge
