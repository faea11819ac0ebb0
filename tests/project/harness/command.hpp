#pragma once
/// @file
/// Runs a program as a user would, and keeps what it says.

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

#include "tumble/core/require.hpp"

namespace tumble::test {

struct CommandResult {
  int status;          ///< exit status; 128 + n for signal n
  std::string output;  ///< stdout and stderr
};

inline CommandResult run_command(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  require(pipe != nullptr, "cannot run ", command);
  std::string output;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr)
    output += buffer.data();
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), output};
}

}  // namespace tumble::test
