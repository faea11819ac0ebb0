#pragma once
/// @file
/// What a program is allowed, and which of the walls around it this machine can build.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tumble::judge {

namespace fs = std::filesystem;

struct Limits {
  int cpu_seconds = 2;
  double wall_seconds = 10;  ///< kept by the one who waits: Conversation, run()
  std::uint64_t memory_bytes = 512ull << 20;
  std::uint64_t stack_bytes = 8ull << 20;  ///< of it
  std::uint64_t file_bytes = 0;            ///< largest file it may write
  std::uint64_t processes =
      0;  ///< it may start; counted per user, so only where it has one for itself
};

/// What this machine grants less of, by limits of its own (ulimit): "300 MB of memory instead of
/// 512 MB"; empty if nothing.
std::string lowered_limits(const Limits& limits);

/// A wall. A worker stands behind all of them, the compiler behind all but the system calls.
enum class Wall {
  limits,        ///< setrlimit: processor time, memory, file size
  other_user,    ///< neither the files nor the processes of the one who judges (needs root)
  files,         ///< Landlock: no file but those that are listed
  system_calls,  ///< seccomp: no system call but those that arithmetic and printing need
};

/// The user that confined programs run as when the judge is root: "nobody".
inline constexpr unsigned unprivileged_id = 65534;

/// Files and folders that may be opened; everything else is refused by Wall::files.
struct OpenFiles {
  std::vector<fs::path> read;  ///< and execute
  std::vector<fs::path> write;
};

/// Which system calls a program may make.
enum class CallRules {
  all,
  worker,     ///< those of computing and printing
  sanitizer,  ///< all but those that reach other processes, the network, or more rights
};

struct Walls {
  Limits limits;
  OpenFiles files;
  fs::path folder;         ///< where it starts
  bool other_user = true;  ///< where the judge is root
  CallRules system_calls = CallRules::all;
};

/// A wall that cannot be built here, and why.
struct MissingWall {
  Wall wall;
  std::string why;
};

std::string name_of(Wall wall);

/// Becomes the unprivileged user, for good. Async-signal-safe.
/// @return whether that went well
bool become_unprivileged();

/// Whether this process may: root may, but not root of a container that lacks the right, nor root
/// of a user namespace (unshare -r, rootless containers), where nobody else is known.
bool may_become_unprivileged();

/// May every user pass through all folders of this path?
bool others_may_enter(const fs::path& path);

/// Tries every wall in a child of its own.
std::vector<MissingWall> missing_walls();

}  // namespace tumble::judge
