/// @file
/// What is not the student's doing: the judge fails at one exercise, or the machine does.
#include <doctest/doctest.h>
#include <sys/mount.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "judge/sandbox/platform.hpp"
#include "project/harness/command.hpp"
#include "project/harness/skip.hpp"
#include "project/harness/temporary_folder.hpp"
#include "support/text_file.hpp"

using namespace tumble;
using test::CommandResult;
using test::run_command;
namespace fs = std::filesystem;

namespace {

const fs::path fixture_course = std::getenv("TUMBLE_FIXTURE");
const std::string program = "'" + std::string(std::getenv("TUMBLE_FIXTURE_JUDGE")) + "' ";

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string solution(const std::string& name) {
  return support::read_text(fixture_course / "solutions/01_crossing" / (name + ".cpp"));
}

/// A class of one student, both exercises right but for what is changed.
struct Student {
  test::TemporaryFolder work;
  fs::path files = work.path() / "class/ann/01_crossing", out = work.path() / "grades";

  Student() {
    for (const char* name : {"carry", "twice"})
      support::write_text_and_folders(files / (std::string(name) + ".cpp"), solution(name));
  }
  CommandResult check(const std::string& before = "") const {
    return run_command(before + program + "check all --seed 3 --from '" +
                       (work.path() / "class/ann").string() + "'");
  }
  CommandResult grade(const std::string& before = "") const {
    return run_command(before + program + "grade '" + (work.path() / "class").string() +
                       "' --out '" + out.string() + "'");
  }
  std::string csv() const { return support::read_text(out / "grades.csv"); }
};

/// Its program asks for an interpreter, which the walls refuse: the judge cannot start it.
const std::string with_interpreter =
    "__attribute__((section(\".interp\"), used)) const char loader[] = "
    "\"/lib64/ld-linux-x86-64.so.2\";\n";

}  // namespace

TEST_CASE("a failure of the judge at one exercise is that exercise's verdict, the next is judged") {
  const Student student;
  support::write_text(student.files / "carry.cpp", solution("carry") + with_interpreter);
  const CommandResult checked = student.check();
  CHECK_MESSAGE(says(checked.output, "1.2 twice  passed"), checked.output);
  if (says(checked.output, "1.1 carry  forbidden"))
    return test::skip("here the walls stop such a program only when it runs");
  CHECK_MESSAGE(checked.status == 2, checked.output);
  CHECK_MESSAGE(says(checked.output, "1.1 carry  judge failed"), checked.output);
  CHECK_MESSAGE(says(checked.output, "The judge failed here: "), checked.output);

  const CommandResult graded = student.grade();
  CHECK_MESSAGE(graded.status == 2, graded.output);
  CHECK_MESSAGE(says(graded.output, "the judge failed at ann, 1.1 carry"), graded.output);
  CHECK_MESSAGE(says(student.csv(), "the judge failed at 1.1: no verdict,,1"), student.csv());
  CHECK(says(support::read_text(student.out / "junit.xml"), "errors=\"1\""));

  support::write_text(student.files / "carry.cpp", solution("carry"));
  CHECK(student.grade().status == 0);
  CHECK_MESSAGE(says(student.csv(), "ann,2,2,100,2,,1,1"), student.csv());
}

TEST_CASE("limits of the student's shell are lowered, not a wall that is missing") {
  const Student student;
  std::vector<std::string> limits = {"ulimit -t 5; "};
  if (!TUMBLE_HAS_ASAN)  // which has terabytes of its own
    limits.insert(limits.end(), {"ulimit -v 3000000; ", "ulimit -v 8000000; ulimit -t 20; "});
  for (const std::string& limit : limits) {
    const CommandResult checked = student.check(limit);
    CHECK_MESSAGE(says(checked.output, "2 of 2 exercises pass"), limit, checked.output);
    CHECK_MESSAGE(!says(checked.output, "the sandbox lacks a list"), checked.output);
  }
}

TEST_CASE("memory that this machine does not grant is no student's zero") {
  if (TUMBLE_HAS_ASAN) return test::skip("its memory is terabytes: no limit can be set");
  const Student student;
  support::write_text(student.files / "carry.cpp",
                      solution("carry") + "const std::vector<char> much(400u << 20, 'm');\n");
  const CommandResult graded = student.grade("ulimit -v 400000; ");
  CHECK_MESSAGE(graded.status == 2, graded.output);
  CHECK_MESSAGE(says(graded.output, "this machine allows"), graded.output);
  CHECK_MESSAGE(says(student.csv(), "the judge failed at 1.1: no verdict"), student.csv());
}

TEST_CASE("a temporary folder that other users may not enter is no student's fault") {
  const Student student;  // its folder is such a one
  const fs::path own = student.work.path() / "temporary";
  fs::create_directory(own);
  const CommandResult graded = student.grade("TMPDIR='" + own.string() + "' ");
  CHECK_MESSAGE(graded.status == 0, graded.output);
  CHECK_MESSAGE(says(student.csv(), "ann,2,2,100,2,,1,1"), student.csv());
}

TEST_CASE("files that may not be as long as they have to be: no end without a word") {
  const Student student;
  const CommandResult graded = student.grade("ulimit -f 1; ");
  CHECK_MESSAGE(graded.status == 2, graded.output);
  CHECK_MESSAGE(says(graded.output, "tumble: "), graded.output);
  CHECK_MESSAGE(says(graded.output, "File too large"), graded.output);
  CHECK(student.grade().status == 0);
  CHECK_MESSAGE(says(student.csv(), "ann,2,2,100,2,,1,1"), student.csv());
}

TEST_CASE("a full disk is no student's zero: nothing is counted, and the next grading judges") {
  const Student student;
  const fs::path small = student.work.path() / "small";
  fs::create_directory(small);
  if (::mount("tmpfs", small.c_str(), "tmpfs", 0, "size=300k,mode=1777") != 0)
    return test::skip("no small disk can be made here: only root may mount");
  const CommandResult graded = student.grade("TMPDIR='" + small.string() + "' ");
  ::umount(small.c_str());
  CHECK_MESSAGE(graded.status == 2, graded.output);
  CHECK_MESSAGE(says(graded.output, "the judge failed at ann"), graded.output);
  CHECK_MESSAGE(says(student.csv(), "the judge failed at 1.1, 1.2: no verdict\",,"), student.csv());
  CHECK(student.grade().status == 0);
  CHECK_MESSAGE(says(student.csv(), "ann,2,2,100,2,,1,1"), student.csv());
}
