#include "judge/sandbox/walls.hpp"

#include <grp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

#include "judge/sandbox/confined_process.hpp"
#include "judge/sandbox/open_files.hpp"
#include "judge/sandbox/platform.hpp"
#include "judge/sandbox/system_calls.hpp"

namespace tumble::judge {

std::string name_of(Wall wall) {
  switch (wall) {
    case Wall::limits:
      return "limits of time and memory";
    case Wall::other_user:
      return "another user";
    case Wall::files:
      return "a list of files that may be opened (Landlock)";
    case Wall::system_calls:
      return "a list of system calls (seccomp)";
  }
  return "unknown wall";
}

namespace {

/// "8 MB", and below one of them "200 KB", below one of these "100 bytes": none that is there is 0.
std::string amount(std::uint64_t bytes) {
  if (bytes >= 1 << 20) return std::to_string(bytes >> 20) + " MB";
  return bytes >= 1 << 10 ? std::to_string(bytes >> 10) + " KB" : std::to_string(bytes) + " bytes";
}

}  // namespace

std::string lowered_limits(const Limits& limits) {
  const auto lowered = [](platform::Resource resource, std::uint64_t wanted, const char* what) {
    const std::uint64_t granted = platform::granted(resource);
    if (granted >= wanted) return std::string();
    return amount(granted) + " " + what + " instead of " + amount(wanted);
  };
  for (const std::string& text : {lowered(RLIMIT_AS, limits.memory_bytes, "of memory"),
                                  lowered(RLIMIT_STACK, limits.stack_bytes, "of stack"),
                                  lowered(RLIMIT_FSIZE, limits.file_bytes, "in a file")})
    if (!text.empty()) return text;
  const std::uint64_t seconds = platform::granted(RLIMIT_CPU);
  const auto wanted = static_cast<std::uint64_t>(limits.cpu_seconds);
  if (seconds >= wanted) return {};
  return std::to_string(seconds) + " s of computing instead of " + std::to_string(wanted);
}

bool become_unprivileged() {
  return setgroups(0, nullptr) == 0 && setregid(unprivileged_id, unprivileged_id) == 0 &&
         setreuid(unprivileged_id, unprivileged_id) == 0;
}

namespace {

bool child_becomes_unprivileged() {
  const pid_t child = fork();
  if (child == 0) _exit(become_unprivileged() ? 0 : 1);
  int status = 1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return child > 0 && status == 0;
}

}  // namespace

bool may_become_unprivileged() {
  static const bool may = geteuid() == 0 && child_becomes_unprivileged();
  return may;
}

bool others_may_enter(const fs::path& path) {
  for (fs::path folder = path; folder != folder.root_path(); folder = folder.parent_path())
    if ((fs::status(folder).permissions() & fs::perms::others_exec) == fs::perms::none)
      return false;
  return true;
}

namespace {

/// Does a process start behind `walls`? Behind a call filter a program that is
/// linked dynamically cannot come up, but the walls have to stand before it fails.
std::string failure_of(const Walls& walls) {
  try {
    ConfinedProcess probe({platform::do_nothing()}, {}, walls, {-1, -1, -1});
    probe.wait(5);
    return {};
  } catch (const std::runtime_error& e) {
    return e.what();
  }
}

}  // namespace

std::vector<MissingWall> missing_walls() {
  std::vector<MissingWall> missing;
  Walls walls;
  walls.folder = "/";
  walls.files.read = {"/"};
  if (const std::string why = failure_of(walls); !why.empty())
    missing.push_back({Wall::limits, why});
  if (!may_become_unprivileged())
    missing.push_back({Wall::other_user, geteuid() == 0
                                             ? "root of this container may not become another user"
                                             : "only root can become another user"});
  if (!file_rules_available())
    missing.push_back({Wall::files, "this kernel has no Landlock, or does not allow it here"});
  walls.system_calls = CallRules::worker;
  if (!call_filters_available())
    missing.push_back({Wall::system_calls, "this system has no seccomp"});
  else if (const std::string why = failure_of(walls); !why.empty())
    missing.push_back({Wall::system_calls, why});
  return missing;
}

}  // namespace tumble::judge
