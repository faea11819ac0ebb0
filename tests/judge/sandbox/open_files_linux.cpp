#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <linux/landlock.h>

#include "judge/sandbox/open_files.hpp"

namespace tumble::judge {

namespace {

// Debian 12's headers know the first version of Landlock: its rights are enough to close all files.
constexpr std::uint64_t reading =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t everything = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
constexpr std::uint64_t rights_of_a_file =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;

void add_rule(int rules, const fs::path& path, std::uint64_t rights) {
  const int file = open(path.c_str(), O_PATH | O_CLOEXEC);
  if (file < 0) return;
  struct stat status = {};
  fstat(file, &status);
  landlock_path_beneath_attr rule = {};
  rule.parent_fd = file;
  rule.allowed_access = S_ISDIR(status.st_mode) ? rights : rights & rights_of_a_file;
  syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
  close(file);
}

}  // namespace

bool file_rules_available() {
  return syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) >= 1;
}

FileRules::FileRules(const OpenFiles& files) {
  if (!file_rules_available()) return;
  landlock_ruleset_attr attributes = {};
  attributes.handled_access_fs = everything;
  rules_ =
      static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
  if (rules_ < 0) return;
  for (const fs::path& path : files.read) add_rule(rules_, path, reading);
  for (const fs::path& path : files.write) add_rule(rules_, path, everything);
}

FileRules::~FileRules() {
  if (rules_ >= 0) close(rules_);
}

bool FileRules::install() const {
  return rules_ < 0 || syscall(SYS_landlock_restrict_self, rules_, 0) == 0;
}

}  // namespace tumble::judge
