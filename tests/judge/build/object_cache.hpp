#pragma once
/// @file
/// Files that were compiled before: in a class many are the same, the untouched stubs above all.

#include <filesystem>
#include <optional>
#include <string>

#include "judge/build/worker_build.hpp"

namespace tumble::judge {

/// What the compiler has made of each text, and what became of the stubs. Several judges may use
/// one folder at a time.
class ObjectCache {
 public:
  /// @param folder nobody else may write there
  explicit ObjectCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// What came of this very text, its object copied to `object`.
  std::optional<WorkerBuild> find(const Unit& unit, const std::string& text,
                                  const std::filesystem::path& object) const;
  /// Keeps what depends on the text alone: not that a machine was too busy.
  void keep(const Unit& unit, const std::string& text, const WorkerBuild& build) const;

  /// The verdict on the untouched exercise, as encode_result() writes it: it is the same whatever
  /// the inputs are, for nothing is computed from them.
  std::optional<std::string> verdict_on_stub(const Unit& unit) const;
  void keep_verdict_on_stub(const Unit& unit, const std::string& verdict) const;

 private:
  std::filesystem::path place_of(const Unit& unit, const std::string& text) const;
  std::filesystem::path place_of_stub(const Unit& unit) const;

  std::filesystem::path folder_;
};

}  // namespace tumble::judge
