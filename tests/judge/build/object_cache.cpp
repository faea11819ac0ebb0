#include "judge/build/object_cache.hpp"

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "judge/course/stable_hash.hpp"
#include "support/json_bytes.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

using nlohmann::json;
using support::bytes_of, support::text_in;

}  // namespace

fs::path ObjectCache::place_of(const Unit& unit, const std::string& text) const {
  return folder_ / (unit.chapter + "-" + unit.name + "-" + std::to_string(stable_hash(text)));
}

std::optional<WorkerBuild> ObjectCache::find(const Unit& unit, const std::string& text,
                                             const fs::path& object) const {
  const fs::path place = place_of(unit, text);
  if (!fs::exists(place)) return std::nullopt;
  const json kept = json::from_msgpack(support::read_text(place / "build"));
  if (text_in(kept.at("text")) != text) return std::nullopt;  // somebody has made the hashes meet
  WorkerBuild build;
  build.outcome = static_cast<BuildOutcome>(kept.at("outcome").get<int>());
  build.detail = text_in(kept.at("detail"));
  build.warnings = text_in(kept.at("warnings"));
  if (build.outcome != BuildOutcome::built) return build;
  fs::copy_file(place / "object", object, fs::copy_options::overwrite_existing);
  build.object = object;
  return build;
}

void ObjectCache::keep(const Unit& unit, const std::string& text, const WorkerBuild& build) const {
  const fs::path place = place_of(unit, text);
  if (!build.explained || fs::exists(place)) return;  // it may be this machine's doing
  const fs::path beside = place.string() + "." + std::to_string(::getpid());
  fs::create_directory(beside);
  const std::vector<std::uint8_t> message =
      json::to_msgpack({{"text", bytes_of(text)},
                        {"outcome", static_cast<int>(build.outcome)},
                        {"detail", bytes_of(build.detail)},
                        {"warnings", bytes_of(build.warnings)}});
  support::write_text(beside / "build", {message.begin(), message.end()});
  if (build.outcome == BuildOutcome::built) fs::copy_file(build.object, beside / "object");
  std::error_code another_was_quicker;
  fs::rename(beside, place, another_was_quicker);
  if (another_was_quicker) fs::remove_all(beside);
}

fs::path ObjectCache::place_of_stub(const Unit& unit) const {
  return folder_ / (unit.chapter + "-" + unit.name + "-stub");
}

std::optional<std::string> ObjectCache::verdict_on_stub(const Unit& unit) const {
  const fs::path place = place_of_stub(unit);
  if (!fs::exists(place)) return std::nullopt;
  return support::read_text(place);
}

void ObjectCache::keep_verdict_on_stub(const Unit& unit, const std::string& verdict) const {
  const fs::path place = place_of_stub(unit),
                 beside = place.string() + "." + std::to_string(::getpid());
  support::write_text(beside, verdict);
  fs::rename(beside, place);  // another one's is the same
}

}  // namespace tumble::judge
