#pragma once
/// @file
/// One worker of all functions of a student that an engine needs: the only place where nothing is
/// ours but what asks.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "judge/conversation/student_worker.hpp"
#include "judge/course/course.hpp"

namespace tumble::judge::mine {

/// A function of the engine.
struct Part {
  Unit unit;
  fs::path source;      ///< the student's file
  std::string missing;  ///< why the solution is here instead, in a few words; or empty
  std::string detail;   ///< what the compiler says about it

  bool own() const { return missing.empty(); }
};

struct EngineBuild {
  std::vector<Part> parts;                 ///< all that are needed, in the course's order
  std::string does_not_link;               ///< what the linker misses, if it does
  std::vector<std::string> defined_twice;  ///< helpers of which the first one counts for all files
  WorkerProgram worker;                    ///< unless it does not link

  std::vector<Part> missing() const;
  /// The parts of another engine are beside these.
  void add(const EngineBuild& other);
};

/// Builds engines of one student's functions. Each file is compiled once, however many engines take
/// it.
class EngineBuilder {
 public:
  using SourceOf = std::function<fs::path(const Unit&)>;

  /// @param source gives the student's file of a unit
  /// @param folder for what is built; made here
  EngineBuilder(const Course& course, SourceOf source, fs::path folder);
  ~EngineBuilder();

  /// Compiles what these questions call, what that calls, and so on, each behind the judge's walls.
  /// What is missing is taken from the solutions, so that all that is missing is found at once.
  /// @param questions object file of what asks (student/ has the sources)
  /// @throws std::runtime_error if the judge itself is broken
  EngineBuild build(const fs::path& questions);

 private:
  class Linker;
  std::unique_ptr<Linker> linker_;
};

}  // namespace tumble::judge::mine
