#pragma once
/// @file
/// Runs a program as on a machine whose kernel lacks something: a filter of system calls answers
/// for what is not there.

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "project/harness/command.hpp"
#include "project/harness/temporary_folder.hpp"
#include "support/text_file.hpp"

namespace tumble::test {

/// A system call that fails with this error; if a first argument is given, with that one only.
struct MissingCall {
  unsigned number, error;
  std::optional<unsigned> first = std::nullopt;
};

/// The kernel's program that says so of one call, and allows all others.
inline std::vector<sock_filter> filter_against(const MissingCall& call) {
  const auto load = [](std::size_t at) {
    return sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(at));
  };
  const auto unless = [](unsigned value, unsigned char skipped) {
    return sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, skipped);
  };
  const auto answer = [](unsigned action) { return sock_filter BPF_STMT(BPF_RET | BPF_K, action); };
  std::vector<sock_filter> program{load(offsetof(seccomp_data, nr))};
  if (call.first) {
    program.push_back(unless(call.number, 3));
    program.push_back(load(offsetof(seccomp_data, args)));
    program.push_back(unless(*call.first, 1));
  } else {
    program.push_back(unless(call.number, 1));
  }
  program.push_back(answer(SECCOMP_RET_ERRNO | call.error));
  program.push_back(answer(SECCOMP_RET_ALLOW));
  return program;
}

/// Puts this process and its children behind the filter, for good.
inline bool lose(const MissingCall& call) {
  std::vector<sock_filter> filter = filter_against(call);
  const sock_fprog program = {static_cast<unsigned short>(filter.size()), filter.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

inline CommandResult run_without(const std::vector<MissingCall>& calls,
                                 const std::string& command) {
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "log").string();
  const std::string whole = "( " + command + " ) > '" + log + "' 2>&1";
  const pid_t child = ::fork();
  if (child == 0) {
    for (const MissingCall& call : calls)
      if (!lose(call)) ::_exit(126);
    ::execl("/bin/sh", "sh", "-c", whole.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  require(child > 0 && ::waitpid(child, &status, 0) == child, "cannot run ", command);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          support::read_text(log)};
}

}  // namespace tumble::test
