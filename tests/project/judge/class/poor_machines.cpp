/// @file
/// A class graded on machines that lack a wall, or a lock: the grades are right and what is missing
/// is said, or nothing is graded and the reason is said.
#include <doctest/doctest.h>

#ifdef __linux__

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#include "project/harness/skip.hpp"
#include "project/harness/without_calls.hpp"
#include "project/judge/class/handed_in_class.hpp"

using namespace tumble;
using test::CommandResult;
using test::MissingCall;
namespace fs = std::filesystem;

namespace {

// Landlock's numbers are the same on all architectures; headers may be older than it.
constexpr unsigned create_ruleset = 444, restrict_self = 446;

const MissingCall no_landlock{create_ruleset, ENOSYS};
const MissingCall no_filters{SYS_prctl, EINVAL, PR_SET_SECCOMP};

/// A folder and an archive, both right: each goes its own way through the walls.
struct ClassOfTwo {
  test::TemporaryFolder work;
  fs::path handed_in = work.path() / "handed in", out = work.path() / "grades";

  ClassOfTwo() {
    test::write_files(handed_in / "ann", test::both());
    test::write_archive(handed_in / "ben.zip", test::both());
  }
  CommandResult grade_without(const std::vector<MissingCall>& calls,
                              const std::string& options = "") const {
    return test::run_without(calls, "'" + test::variable("TUMBLE_FIXTURE_JUDGE").string() +
                                        "' grade '" + handed_in.string() + "' --out '" +
                                        out.string() + "' " + options);
  }
  bool both_have_all_points() const {
    const std::string table = test::text_of(out / "grades.csv");
    return table.find("\nann,2,2,") != std::string::npos &&
           table.find("\nben,2,2,") != std::string::npos;
  }
};

void check_said(const CommandResult& graded, int status, const std::string& line) {
  CHECK_MESSAGE(graded.status == status, graded.output);
  CHECK_MESSAGE(graded.output.find(line) != std::string::npos, graded.output);
}

}  // namespace

TEST_CASE("a machine without Landlock, without seccomp, or without both: said, and graded right") {
  const std::string lacks = "the sandbox lacks a list of ";
  const ClassOfTwo files, calls, both;
  check_said(files.grade_without({no_landlock}), 0, lacks + "files that may be opened (Landlock)");
  CHECK(files.both_have_all_points());
  check_said(calls.grade_without({no_filters}), 0, lacks + "system calls (seccomp)");
  CHECK(calls.both_have_all_points());
  const CommandResult neither = both.grade_without({no_landlock, no_filters});
  check_said(neither, 0, lacks + "files");
  check_said(neither, 0, lacks + "system calls");
  CHECK(both.both_have_all_points());
}

TEST_CASE("a machine without a wall grades nothing where all are demanded") {
  const ClassOfTwo two;
  for (const MissingCall& call : {no_landlock, no_filters})
    check_said(two.grade_without({call}, "--strict"), 2, "--strict: nothing is judged");
  CHECK_FALSE(fs::exists(two.out / "grades.csv"));
}

TEST_CASE("root that may not become another user, as in rootless containers: said, graded right") {
  if (::geteuid() != 0) return test::skip("only root can become another user");
  const ClassOfTwo two;
  check_said(two.grade_without({{SYS_setgroups, EPERM}}), 0,
             "the sandbox lacks another user: root of this container may not become another user");
  CHECK(two.both_have_all_points());
}

TEST_CASE("a machine on which no process can be confined grades nothing, and writes no zeros") {
  const ClassOfTwo two;
  const CommandResult graded = two.grade_without({{restrict_self, EPERM}});
  check_said(graded, 2, "file rules (Landlock): Operation not permitted");
  check_said(graded, 2, "nothing can be judged here, as no process can be confined");
  CHECK_FALSE(fs::exists(two.out / "grades.csv"));
}

TEST_CASE("a file system without locks is said, and graded on") {
  const ClassOfTwo two;
  check_said(two.grade_without({{SYS_flock, ENOLCK}}), 0,
             "has no locks (No locks available): start no other grading in this folder");
  CHECK(two.both_have_all_points());
}

#endif
