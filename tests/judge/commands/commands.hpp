#pragma once
/// @file
/// What a student, an instructor or a test can ask of the judge. Each command returns the exit
/// status: 0 if what it is for was achieved. Those that grade are in a module: grading_module.hpp.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/course/course.hpp"
#include "judge/platforms/package.hpp"

namespace tumble::judge {

struct CheckOptions {
  std::string what;  ///< unit, chapter, "4.1.3" for one case, empty for the next open unit
  std::optional<std::uint64_t> seed;  ///< of the inputs; another one each time if not given
  int seeds = 1;                      ///< how many, one after the other
  std::optional<fs::path> from;       ///< folder with the files, instead of exercises/
  std::optional<fs::path> json;       ///< where to write the results
  bool solutions = false;             ///< judge the solutions
  bool every_case = false;            ///< explain every case that fails
  bool strict = false;                ///< refuse to judge if a wall of the sandbox is missing
  bool sanitized = false;             ///< run everything with sanitizers
  bool once = false;                  ///< no second run, with sanitizers, of a case that fails
  std::optional<fs::path> student;    ///< a record of `grade`: what that student saw
};

struct MineOptions {
  std::optional<fs::path> from;  ///< folder with the files, instead of exercises/
  std::optional<fs::path> svg;   ///< where the figure goes; build/mine.svg if not given
  std::optional<fs::path> json;  ///< where to write the numbers
  bool fill = false;             ///< take what is missing from the solutions
  bool strict = false;           ///< refuse to run anything if a wall of the sandbox is missing
};

struct GradeOptions {
  std::vector<fs::path> folders;       ///< of submissions
  fs::path out = "grades";             ///< folder for the results; those that are there are resumed
  std::optional<fs::path> settings;    ///< course.json
  std::optional<std::size_t> at_once;  ///< submissions; as many as there are cores if not given
  std::optional<std::string> from;     ///< the platform of the download
  std::optional<fs::path> roster;      ///< table of the class
  std::vector<std::string> only;       ///< units and chapters to judge again
  std::vector<std::string> students;   ///< to judge; all if none is named
  bool strict = false;                 ///< refuse to judge if a wall of the sandbox is missing
  std::optional<double> seconds;       ///< after these no exercise is begun
  std::optional<std::string> shard;    ///< "3/10": judge this part of the class
  std::vector<fs::path> merge;         ///< folders of shards, instead of submissions
};

struct ReportOptions {
  fs::path grades = "grades";  ///< what `grade` has made
  fs::path out = "report.html";
  std::optional<fs::path> settings;  ///< course.json
  bool names = false;                ///< the students' too
};

struct HandoutOptions {
  std::string chapters;              ///< "1-4,6"; or empty, and those of `settings`
  std::optional<fs::path> settings;  ///< course.json
  fs::path to;                       ///< a new folder
};

struct PlatformOptions {
  std::string platform;              ///< "gradescope", …
  fs::path root;                     ///< of its folders
  std::optional<fs::path> settings;  ///< course.json
  std::optional<double> seconds;     ///< after these no exercise is begun
};

/// What `check` judges: "4.1", "product", "4", "all", "4.1.3" for one case; the next open unit if
/// empty, or none if all are done.
/// @throws std::invalid_argument if there is no such thing
std::vector<Unit> units_to_check(const Course& course, const std::string& what);
/// Judges what was asked for, explains, and remembers.
int check(const Course& course, const CheckOptions& options);
/// Builds an engine of the student's own functions, and shows its errors beside the library's.
int mine_command(const Course& course, const MineOptions& options);
/// Judges each file when it is saved, until interrupted.
int watch(const Course& course);
/// All units with what is known about them.
int list(const Course& course);
/// Shows the next hint, or the one with this number, for this unit or for the next open one.
int hint(const Course& course, const std::string& what, int number);
/// Puts the untouched stub back, and keeps what was there.
int reset(const Course& course, const std::string& what);
/// Shows the solution of a unit that passes.
int solution(const Course& course, const std::string& what, bool anyway);
/// Which walls of the sandbox stand here.
int sandbox(const Course& course);
/// Every misconception is killed and named: a table.
int matrix(const Course& course, const std::string& what, std::uint64_t seed);
/// What students get wrong: a page of the book.
int misconceptions_page(const Course& course, const std::string& what);
/// The judge survives answers and evaluations of any size and with any numbers: tries them.
int odd_answers(const Course& course, const std::string& what, std::uint64_t seed);
/// Every exercise in the tree is the untouched stub, and fails every case of its spec.
int stubs(const Course& course);

}  // namespace tumble::judge
