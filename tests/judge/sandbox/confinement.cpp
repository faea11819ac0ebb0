#include "judge/sandbox/confinement.hpp"

#include <unistd.h>

#include <stdexcept>

#include "judge/sandbox/confined_process.hpp"
#include "judge/sandbox/open_files.hpp"
#include "judge/sandbox/platform.hpp"
#include "judge/sandbox/system_calls.hpp"

namespace tumble::judge {

std::string name_of(Layer layer) {
  switch (layer) {
    case Layer::limits:
      return "limits of time and memory";
    case Layer::other_user:
      return "another user";
    case Layer::files:
      return "a list of files that may be opened (Landlock)";
    case Layer::system_calls:
      return "a list of system calls (seccomp)";
  }
  return "unknown layer";
}

bool others_may_enter(const fs::path& path) {
  for (fs::path folder = path; folder != folder.root_path(); folder = folder.parent_path())
    if ((fs::status(folder).permissions() & fs::perms::others_exec) == fs::perms::none)
      return false;
  return true;
}

namespace {

/// Does a process start behind the walls of `confinement`? Behind a call filter a program that is
/// linked dynamically cannot come up, but the walls have to stand before it fails.
std::string failure_of(const Confinement& confinement) {
  try {
    ConfinedProcess probe({platform::do_nothing()}, {}, confinement, {-1, -1, -1});
    probe.wait(5);
    return {};
  } catch (const std::runtime_error& e) {
    return e.what();
  }
}

}  // namespace

std::vector<MissingLayer> missing_layers() {
  std::vector<MissingLayer> missing;
  Confinement walls;
  walls.folder = "/";
  walls.files.read = {"/"};
  if (const std::string why = failure_of(walls); !why.empty())
    missing.push_back({Layer::limits, why});
  if (geteuid() != 0) missing.push_back({Layer::other_user, "only root can become another user"});
  if (!file_rules_available())
    missing.push_back({Layer::files, "this kernel has no Landlock, or does not allow it here"});
  walls.system_calls = CallRules::worker;
  if (!call_filters_available())
    missing.push_back({Layer::system_calls, "this system has no seccomp"});
  else if (const std::string why = failure_of(walls); !why.empty())
    missing.push_back({Layer::system_calls, why});
  return missing;
}

}  // namespace tumble::judge
