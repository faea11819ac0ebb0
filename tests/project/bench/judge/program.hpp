#pragma once
/// @file
/// A program that is run as a user runs it, timed, and killed.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::bench {

/// What a program has cost, with all that it has started and waited for.
struct Cost {
  double wall = 0;       ///< [s]
  double processor = 0;  ///< [s]
};

class Program {
 public:
  /// Starts it; what it says goes into `log`.
  /// @param cores that it may use, where the system can restrict it; 0: all
  Program(const std::vector<std::string>& command, const std::filesystem::path& log,
          std::size_t cores = 0);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  /// Has it ended?
  bool ended();
  /// SIGKILL for it alone, as a user does it; what it has started is not told.
  void kill();
  /// Waits for the end. @return its exit status; 128 + n if signal n has ended it
  int wait();
  /// Once it has ended.
  Cost cost() const { return cost_; }

 private:
  void note_end(int status, double processor);

  pid_t pid_;
  double start_;
  int status_ = -1;  ///< until it has ended
  Cost cost_;
};

/// Runs a program to its end.
/// @throws std::runtime_error with its last words unless it ends with one of these statuses
Cost run_to_end(const std::vector<std::string>& command, const std::filesystem::path& log,
                const std::vector<int>& statuses = {0}, std::size_t cores = 0);

/// How many cores this process may use; 0 if the system can't restrict a program to fewer.
std::size_t cores_to_choose_from();

/// From now on, this process is told of all that its children leave running when they die.
/// @return whether this system can do that
bool adopt_orphans();

/// Waits until no orphan is left, a few seconds at most.
/// @return whether none is
bool orphans_are_gone();

}  // namespace tumble::bench
