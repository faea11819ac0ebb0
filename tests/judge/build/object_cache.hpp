#pragma once
/// @file
/// Files that were compiled before: in a class many are the same, the untouched stubs above all.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "judge/build/worker_build.hpp"

namespace tumble::judge {

/// What the compiler has made of each text, and what became of the stubs. Several judges may use
/// one folder at a time.
class ObjectCache {
 public:
  /// What becomes of the verdicts on stubs.
  enum class Stubs { judged_once, judged_again };

  /// @param folder nobody else may write there
  explicit ObjectCache(std::filesystem::path folder, Stubs stubs = Stubs::judged_once)
      : folder_(std::move(folder)), stubs_(stubs) {}

  /// What came of this very text, its object copied to `object`. What cannot be read was not kept.
  std::optional<WorkerBuild> find(const Unit& unit, const std::string& text,
                                  const std::filesystem::path& object) const;
  /// Keeps what depends on the text alone: not that a machine was too busy. Where there is no room,
  /// nothing is kept.
  void keep(const Unit& unit, const std::string& text, const WorkerBuild& build) const;

  /// The verdict on the untouched exercise, as encode_result() writes it: it is the same whatever
  /// the inputs are, for nothing is computed from them.
  std::optional<std::string> verdict_on_stub(const Unit& unit) const;
  void keep_verdict_on_stub(const Unit& unit, const std::string& verdict) const;

  /// Whether the course's own solution was seen to pass on this machine.
  bool solution_passes(const Unit& unit) const;
  void keep_that_solution_passes(const Unit& unit) const;

 private:
  std::filesystem::path place_of(const Unit& unit, const std::string& text) const;
  std::filesystem::path place_of_stub(const Unit& unit) const;
  std::filesystem::path place_of_solution(const Unit& unit) const;

  std::filesystem::path folder_;
  Stubs stubs_;
};

/// What earlier commands have compiled, beside the course's own build: for those who judge their
/// own files. A class's are compiled in folders of their own. It holds for one compiler with its
/// flags and headers, and for these contracts.
/// @return nothing where that folder cannot be written
std::unique_ptr<const ObjectCache> objects_of_earlier(const Course& course);

}  // namespace tumble::judge
