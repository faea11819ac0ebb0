#pragma once
/// @file
/// Files that were compiled before: in a class many are the same, the untouched stubs above all.

#include <filesystem>
#include <optional>
#include <string>

#include "judge/build/worker_build.hpp"

namespace tumble::judge {

/// What the compiler has made of each text. Several judges may use one folder at a time.
class ObjectCache {
 public:
  /// @param folder nobody else may write there
  explicit ObjectCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// What came of this very text, its object copied to `object`.
  std::optional<WorkerBuild> find(const Unit& unit, const std::string& text,
                                  const std::filesystem::path& object) const;
  /// Keeps what depends on the text alone: not that a machine was too busy.
  void keep(const Unit& unit, const std::string& text, const WorkerBuild& build) const;

 private:
  std::filesystem::path place_of(const Unit& unit, const std::string& text) const;

  std::filesystem::path folder_;
};

}  // namespace tumble::judge
