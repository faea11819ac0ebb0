#pragma once
/// @file
/// The system calls that a confined program may make, kept by the kernel (seccomp).

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "judge/sandbox/walls.hpp"

namespace tumble::judge {

/// A program of the kernel's filter machine: 8 bytes an instruction.
using CallFilter = std::vector<std::uint64_t>;

/// The filter for `rules`; empty for CallRules::all, and where the system has no filters. A call
/// that a worker may not make raises SIGSYS, which it reports.
/// @throws std::runtime_error if libseccomp cannot build it
const CallFilter& call_filter(CallRules rules);

/// Whether this system has such filters.
bool call_filters_available();

/// Puts this process behind the filter. Async-signal-safe: called between fork and exec.
/// @return whether the kernel has accepted it
bool install_call_filter(const CallFilter& filter);

/// Starts the prepared path. Behind a filter a program can be started this way only:
/// the kernel compares the *address* of the path, and the page that holds it exists in the judge
/// alone. Returns only if it fails.
void execute_behind_filter(const char* const argv[], const char* const environment[]);

/// What a refused call was for, in words: "open a file", "start a thread or a process", …
std::string purpose_of_call(int number);
/// Its name: "openat".
std::string name_of_call(int number);
/// Is this the call by which abort() ends a program?
bool is_abort(int number);

/// Where execute_behind_filter finds its path: call it with the path before forking.
void prepare_path(const std::string& path);

}  // namespace tumble::judge
