#pragma once
/// @file
/// What the judge and its workers take from their system, where systems differ. Where it is not
/// Linux, or the build says TUMBLE_PORTABLE_WORKER, limits are the only wall.

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>

#if defined(__linux__) && !defined(TUMBLE_PORTABLE_WORKER)
#define TUMBLE_LINUX_WALLS 1
#include <sys/prctl.h>

#include <csignal>
#else
#define TUMBLE_LINUX_WALLS 0
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

inline bool limit_resource(int resource, std::uint64_t soft, std::uint64_t hard) {
  const rlimit limit = {static_cast<rlim_t>(soft), static_cast<rlim_t>(hard)};
#ifdef __linux__
  return setrlimit(static_cast<__rlimit_resource>(resource), &limit) == 0;
#else
  return setrlimit(resource, &limit) == 0;
#endif
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

/// A program that does nothing, and succeeds.
inline const char* do_nothing() {
  return ::access("/bin/true", X_OK) == 0 ? "/bin/true" : "/usr/bin/true";
}

}  // namespace tumble::judge::platform
