#pragma once
/// @file
/// What the folder of a shard says of it: enough to make the class's tables of the records, without
/// the submissions, and to see that shards belong together.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/class/class_roll.hpp"
#include "judge/class/grade_class.hpp"
#include "judge/class/shard.hpp"

namespace tumble::judge {

struct ShardManifest {
  Shard shard;
  std::uint64_t seed = 1;                       ///< of the class's inputs
  std::optional<std::string> settings;          ///< the text of course.json
  std::map<std::string, std::uint64_t> judges;  ///< fingerprints, by units that count
  ClassRoll roll;                               ///< of the whole class
};

/// A shard, and where it was found.
struct FoundShard {
  GradesFolder folder;
  ShardManifest manifest;
};

/// The file that keeps one in a folder.
std::filesystem::path manifest_of(const GradesFolder& folder, const Shard& shard);

void write_manifest(const GradesFolder& folder, const ShardManifest& manifest);

/// All that a folder has, in the order of their numbers.
/// @throws std::runtime_error naming the file if one cannot be understood
std::vector<FoundShard> shards_in(const GradesFolder& folder);

/// @throws std::invalid_argument if a folder has shards of another number of them: a student would
/// be in two
void require_same_cut(const GradesFolder& folder, const Shard& shard);

}  // namespace tumble::judge
