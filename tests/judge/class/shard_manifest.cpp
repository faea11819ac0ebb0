#include "judge/class/shard_manifest.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/verdict/json.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

using nlohmann::ordered_json;

namespace {

ordered_json json_of(const ShardManifest& manifest) {
  ordered_json j{{"schema", "tumble/shard/1"},
                 {"shard", manifest.shard.number},
                 {"of", manifest.shard.of},
                 {"seed", manifest.seed},
                 {"judges", manifest.judges}};
  if (manifest.settings) j["settings"] = *manifest.settings;
  j["left_out"] = ordered_json::array();
  for (const LeftOut& each : manifest.roll.left_out)
    j["left_out"].push_back(ordered_json::object({{"what", each.what}, {"why", each.why}}));
  j["class"] = judge::json_of(manifest.roll);
  return j;
}

ShardManifest manifest_in(const ordered_json& j) {
  ShardManifest manifest;
  manifest.shard = {j.at("shard"), j.at("of")};
  manifest.seed = j.at("seed");
  manifest.judges = j.at("judges").get<std::map<std::string, std::uint64_t>>();
  if (j.contains("settings")) manifest.settings = j.at("settings");
  manifest.roll = class_roll_of(j.at("class"));
  for (const ordered_json& each : j.at("left_out"))
    manifest.roll.left_out.push_back({each.at("what"), each.at("why")});
  require(manifest.shard == shard_in(name_of(manifest.shard)), "it is not a shard");
  return manifest;
}

ShardManifest read_manifest(const fs::path& file) {
  try {
    return manifest_in(ordered_json::parse(support::read_text(file)));
  } catch (const std::exception& error) {
    throw std::runtime_error(
        file.string() +
        " cannot be understood (./tumble grade --shard writes it): " + error.what());
  }
}

std::vector<fs::path> manifests_in(const GradesFolder& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder.shards())) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.shards()))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

fs::path manifest_of(const GradesFolder& folder, const Shard& shard) {
  return folder.shards() /
         (std::to_string(shard.number) + "-of-" + std::to_string(shard.of) + ".json");
}

void write_manifest(const GradesFolder& folder, const ShardManifest& manifest) {
  support::write_text_and_folders(manifest_of(folder, manifest.shard), text_of(json_of(manifest)));
}

std::vector<FoundShard> shards_in(const GradesFolder& folder) {
  std::vector<FoundShard> found;
  for (const fs::path& file : manifests_in(folder)) found.push_back({folder, read_manifest(file)});
  std::sort(found.begin(), found.end(), [](const FoundShard& a, const FoundShard& b) {
    return a.manifest.shard.number < b.manifest.shard.number;
  });
  return found;
}

void require_same_cut(const GradesFolder& folder, const Shard& shard) {
  const std::string ending = "-of-" + std::to_string(shard.of) + ".json";
  for (const fs::path& file : manifests_in(folder))
    require(file.filename().string().ends_with(ending), folder.path.string(),
            " holds a shard of another division of the class, ", file.string(),
            ". You now divide it into ", shard.of,
            " shards, so students change their shards. Take another folder with --out, or delete ",
            folder.shards().string(), " to divide the class anew: its records stay");
}

}  // namespace tumble::judge
