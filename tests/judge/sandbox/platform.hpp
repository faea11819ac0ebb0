#pragma once
/// @file
/// What the judge and its workers take from their system, where systems differ. Where it is not
/// Linux, or the build says TUMBLE_PORTABLE_WORKER, limits are the only wall.

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include "judge/sandbox/linux_walls.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define TUMBLE_HAS_ASAN 1
#elif defined(__has_feature)
#define TUMBLE_HAS_ASAN __has_feature(address_sanitizer)
#else
#define TUMBLE_HAS_ASAN 0
#endif

#if TUMBLE_LINUX_WALLS
#include <sys/prctl.h>

#include <csignal>
#endif

namespace tumble::judge::platform {

/// Both ends are closed in a program that is started.
inline bool make_pipe(int (&ends)[2]) {
#if TUMBLE_LINUX_WALLS
  return ::pipe2(ends, O_CLOEXEC) == 0;
#else
  return ::pipe(ends) == 0 && ::fcntl(ends[0], F_SETFD, FD_CLOEXEC) == 0 &&
         ::fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0;
#endif
}

/// Closes `first` and all descriptors after it.
inline void close_from(int first) {
  rlimit limit = {};
  getrlimit(RLIMIT_NOFILE, &limit);
#if TUMBLE_LINUX_WALLS
  if (close_range(static_cast<unsigned>(first), ~0u, 0) == 0) return;
#endif
  for (int i = first; i < static_cast<int>(limit.rlim_cur); ++i) close(i);
}

#ifdef __linux__
using Resource = __rlimit_resource;
#else
using Resource = int;
#endif

/// Sets a limit, or the one that is there already where that is lower: a shell's own (ulimit -v,
/// -t) may be lowered, not raised.
inline bool limit_resource(Resource resource, std::uint64_t soft, std::uint64_t hard) {
  rlimit limit = {};
  if (getrlimit(resource, &limit) != 0) return false;
  limit.rlim_max = std::min(static_cast<rlim_t>(hard), limit.rlim_max);
  limit.rlim_cur = std::min(static_cast<rlim_t>(soft), limit.rlim_max);
  return setrlimit(resource, &limit) == 0;
}

/// The most that this machine grants.
inline std::uint64_t granted(Resource resource) {
  rlimit limit = {};
  return getrlimit(resource, &limit) == 0 ? limit.rlim_max : ~0ull;
}

/// The size of a process's memory. macOS refuses a limit below what every process maps from the
/// start: there it has none.
inline bool limit_memory([[maybe_unused]] std::uint64_t bytes) {
#ifdef __APPLE__
  return true;
#else
  return limit_resource(RLIMIT_AS, bytes, bytes);
#endif
}

/// The same for this process alone: what it starts may have more. AddressSanitizer reserves
/// terabytes, so there it has no effect.
inline void limit_own_memory([[maybe_unused]] std::uint64_t bytes) {
#if !defined(__APPLE__) && !TUMBLE_HAS_ASAN
  rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  limit.rlim_cur = std::min(static_cast<rlim_t>(bytes), limit.rlim_max);
  setrlimit(RLIMIT_AS, &limit);
#endif
}

/// Nothing that is started from here on gains rights: no program with set-user-ID, say.
inline bool give_up_rights() {
#if TUMBLE_LINUX_WALLS
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
#else
  return true;
#endif
}

/// This process does not outlive its parent. A change of user undoes this, so it comes after.
inline bool die_with_parent() {
#if TUMBLE_LINUX_WALLS
  return prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
#else
  return true;
#endif
}

/// Whether a process wants to compute, rather than wait for something. (proc(5): the state is the
/// first letter after the name, which is in brackets.) Not known elsewhere.
inline bool is_runnable([[maybe_unused]] pid_t pid) {
#ifdef __linux__
  std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto name_ends = text.rfind(") ");
  return name_ends != std::string::npos && text.compare(name_ends + 2, 1, "R") == 0;
#else
  return false;
#endif
}

/// A program that does nothing, and succeeds.
inline const char* do_nothing() {
  return ::access("/bin/true", X_OK) == 0 ? "/bin/true" : "/usr/bin/true";
}

}  // namespace tumble::judge::platform
