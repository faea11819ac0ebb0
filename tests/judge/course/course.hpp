#pragma once
/// @file
/// What there is to be judged: the units of the course, as the build has written them down.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tumble::judge {

namespace fs = std::filesystem;

/// One exercise: one function in one file.
struct Unit {
  std::string number;             ///< "4.1"
  std::string chapter;            ///< "04_quaternions"
  std::string name;               ///< "product": the function, and the files' name
  fs::path worker;                ///< object file that asks the student's function
  std::vector<fs::path> earlier;  ///< objects or an archive: the solutions of all units before this
  fs::path solution;              ///< object file: its own solution
  fs::path spec = {};             ///< module: its laws and misconceptions; empty in tests

  /// "04_quaternions/product"
  std::string id() const { return chapter + "/" + name; }
  /// "quaternions::product"
  std::string function() const { return chapter.substr(chapter.find('_') + 1) + "::" + name; }
  /// "4"
  std::string chapter_number() const { return number.substr(0, number.find('.')); }
};

/// How a student's file becomes a worker.
struct Toolchain {
  std::string compiler;
  std::string compiler_id;  ///< CMake's: "GNU", "Clang", "AppleClang"
  std::vector<std::string> flags;
  std::vector<std::string> sanitizer_flags;  ///< besides, to find where it crashes
  fs::path precompiled;                      ///< the header that every student's file starts from
  fs::path precompiled_sanitized;            ///< the same, compiled with those flags
  std::string linker;                        ///< as in -fuse-ld=, or empty
  std::vector<std::string> link;             ///< flags of the linker, for every worker
  std::vector<std::string> link_confined;    ///< and for a worker behind walls
  /// and where the first definition of a function counts; empty if the linker knows no such thing
  std::vector<std::string> link_first_counts;
  fs::path runtime;  ///< static library: the worker's side of the protocol
};

struct Course {
  fs::path root;   ///< holds exercises/, solutions/, tests/, chapters/
  fs::path state;  ///< folder where progress and saved attempts are kept
  Toolchain toolchain;
  fs::path engine;   ///< object file that makes an engine of the student's functions; or empty
  fs::path die;      ///< object file that lets their functions drop a die; or empty
  fs::path mine;     ///< module that measures such engines
  fs::path grading;  ///< module that grades classes, and makes hand-outs and packages
  std::vector<Unit> units;
  /// Where a course without solutions finds a function that another one calls; in exercises/ if not
  /// said.
  std::function<fs::path(const Unit&)> stand_in = {};

  /// A hand-out has none.
  bool has_solutions() const { return !units.empty() && !units.front().solution.empty(); }
  /// The file that stands in for the solution of a unit.
  fs::path instead_of_solution(const Unit& unit) const {
    return stand_in ? stand_in(unit) : exercise(unit);
  }

  fs::path contract(const Unit& unit) const {
    return root / "exercises" / unit.chapter / "contract.hpp";
  }
  fs::path exercise(const Unit& unit) const { return file("exercises", unit); }
  fs::path solution(const Unit& unit) const { return file("solutions", unit); }
  fs::path hints(const Unit& unit) const { return root / "exercises" / unit.chapter / "hints.md"; }
  fs::path page(const Unit& unit) const { return root / "chapters" / unit.chapter / "README.md"; }

  /// The units that a student means by "4.1", "product", "04_quaternions/product", "4", "04",
  /// "all", or by the name of a file: "product.cpp", "exercises/04_quaternions/product.cpp".
  /// @throws std::invalid_argument if there are none; the message says what was probably meant
  std::vector<Unit> select(const std::string& what) const;

 private:
  fs::path file(const char* tree, const Unit& unit) const {
    return root / tree / unit.chapter / (unit.name + ".cpp");
  }
};

/// "4.1", "1.2 and 9.4", "4.1 to 4.8"
std::string numbers_of(const std::vector<Unit>& units);

/// Reads what the build has written.
/// @throws std::runtime_error if the file is missing or is not a course
Course read_course(const fs::path& file);

}  // namespace tumble::judge
