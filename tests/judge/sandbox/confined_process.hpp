#pragma once
/// @file
/// A program behind walls: started with nothing but what it is given, and ended for sure.

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "judge/sandbox/walls.hpp"

namespace tumble::judge {

/// How a process has ended.
struct Ending {
  bool by_signal = false;
  int number = 0;  ///< the signal, or the exit status
  bool operator==(const Ending&) const = default;
};

class ConfinedProcess {
 public:
  /// Starts `command` (an absolute path and arguments). File descriptor i of the process is
  /// descriptors[i] of this one, −1 for /dev/null; it has no others.
  /// @throws std::runtime_error naming the wall that could not be built, or the program
  ConfinedProcess(const std::vector<std::string>& command,
                  const std::vector<std::string>& environment, const Walls& walls,
                  const std::vector<int>& descriptors);
  ConfinedProcess(const ConfinedProcess&) = delete;
  ConfinedProcess& operator=(const ConfinedProcess&) = delete;
  /// Kills the process and all that it has started.
  ~ConfinedProcess();

  /// How it has ended, or nothing if it still runs after `seconds`.
  /// @throws std::runtime_error if the system does not let this process wait for it
  std::optional<Ending> wait(double seconds);
  void kill();
  /// Whether it wants to compute and does not get to it: a machine with too much to do.
  bool waits_for_processor() const;
  /// Whether somebody else has killed it: the kernel, when the machine's memory is used up.
  bool killed_from_outside() const;

 private:
  [[noreturn]] void give_up();

  pid_t pid_ = -1;
  std::optional<Ending> ending_;
  int cpu_seconds_allowed_;
  double cpu_seconds_ = 0;  ///< used, once it has ended
  bool killed_here_ = false;
};

/// What a program that ran to its end has printed.
struct Finished {
  Ending ending;
  std::string output;  ///< standard output and error, the first `most_output` bytes
  bool timed_out = false;
  bool killed_from_outside = false;
};

/// Runs a program to its end, or to the limit of time.
/// @param input file descriptor of its standard input, −1 for /dev/null
Finished run_confined(const std::vector<std::string>& command,
                      const std::vector<std::string>& environment, const Walls& walls,
                      std::size_t most_output = 1 << 16, int input = -1);

}  // namespace tumble::judge
