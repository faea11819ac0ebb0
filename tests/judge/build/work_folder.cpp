#include "judge/build/work_folder.hpp"

#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace tumble::judge {

namespace fs = std::filesystem;

namespace {

const std::string prefix = "tumble-judge-";

/// "tumble-judge-1234-XXXXXX" is left over when there is no process 1234.
bool is_left_over(const std::string& name) {
  if (!name.starts_with(prefix)) return false;
  const pid_t pid = std::atoi(name.c_str() + prefix.size());
  return pid > 0 && ::kill(pid, 0) != 0 && errno == ESRCH;
}

void remove_left_overs(const fs::path& place) {
  std::error_code ignored;  // another user's, or removed meanwhile by another judge
  for (const fs::directory_entry& entry : fs::directory_iterator(place, ignored))
    if (is_left_over(entry.path().filename().string())) fs::remove_all(entry.path(), ignored);
}

/// @throws std::runtime_error if there is none
fs::path place_for_folders() {
  std::error_code none;
  fs::path place = fs::temp_directory_path(none);
  if (!none) return place;
  const char* set = ::getenv("TMPDIR");
  throw std::runtime_error("there is no folder for temporary files: " +
                           (set ? "TMPDIR is " + std::string(set) : "/tmp") + ", " +
                           none.message());
}

}  // namespace

WorkFolder::WorkFolder() {
  const fs::path place = place_for_folders();
  remove_left_overs(place);
  std::string name = place / (prefix + std::to_string(::getpid()) + "-XXXXXX");
  if (!::mkdtemp(name.data()))
    throw std::runtime_error("cannot make a folder in " + place.string() + ": " +
                             std::strerror(errno));
  path_ = name;
  // The worker's user may pass through, to what it is given, and see nothing else.
  fs::permissions(path_, fs::perms::owner_all | fs::perms::others_exec);
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace tumble::judge
