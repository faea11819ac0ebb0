#include "judge/build/object_cache.hpp"

#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "judge/course/code_hash.hpp"
#include "judge/course/stable_hash.hpp"
#include "support/json_bytes.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

using nlohmann::json;
using support::bytes_of, support::text_in;

/// @throws std::exception if it cannot be read, or is only a part
std::optional<WorkerBuild> read_from(const fs::path& place, const std::string& text,
                                     const fs::path& object) {
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

/// @throws std::exception if there is no room
void write_to(const fs::path& beside, const std::string& text, const WorkerBuild& build) {
  fs::create_directory(beside);
  const std::vector<std::uint8_t> message =
      json::to_msgpack({{"text", bytes_of(text)},
                        {"outcome", static_cast<int>(build.outcome)},
                        {"detail", bytes_of(build.detail)},
                        {"warnings", bytes_of(build.warnings)}});
  support::write_text(beside / "build", {message.begin(), message.end()});
  if (build.outcome == BuildOutcome::built) fs::copy_file(build.object, beside / "object");
}

/// What an object, and the words about it, depend on beside the file's own text. The precompiled
/// header is made anew when the compiler, its flags, or a header in it changes. What we say of the
/// compiler's messages, the folder "build" says.
std::uint64_t hash_of_surroundings(const Course& course) {
  const Toolchain& tools = course.toolchain;
  std::uint64_t hash = stable_hash(tools.compiler);
  for (const fs::path& file : {fs::canonical(tools.compiler), tools.precompiled})
    hash = stable_hash(file.string() + " " + std::to_string(fs::file_size(file)) + " " +
                           std::to_string(fs::last_write_time(file).time_since_epoch().count()),
                       hash);
  for (const std::string& flag : tools.flags) hash = stable_hash(flag + " ", hash);
  std::set<fs::path> headers{course.root / "exercises" / "not_implemented.hpp"};
  for (const Unit& unit : course.units) headers.insert(course.contract(unit));
  for (const fs::path& header : headers) hash = stable_hash(support::read_text(header), hash);
  return code_hash(code_in(course.root / "tests" / "judge" / "build"), hash);
}

/// Removes what is older than a month, where there is much.
void leave_room(const fs::path& folder) {
  constexpr std::ptrdiff_t much = 2000;
  constexpr std::chrono::hours month{24 * 30};
  std::vector<fs::path> old;
  std::ptrdiff_t all = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    ++all;
    if (entry.last_write_time() + month < fs::file_time_type::clock::now())
      old.push_back(entry.path());
  }
  if (all > much)
    for (const fs::path& place : old) fs::remove_all(place);
}

}  // namespace

fs::path ObjectCache::place_of(const Unit& unit, const std::string& text) const {
  return folder_ / (unit.chapter + "-" + unit.name + "-" + std::to_string(stable_hash(text)));
}

std::optional<WorkerBuild> ObjectCache::find(const Unit& unit, const std::string& text,
                                             const fs::path& object) const {
  const fs::path place = place_of(unit, text);
  try {
    if (fs::exists(place)) return read_from(place, text, object);
  } catch (const std::exception&) {  // half a file, or one that another command has just removed
  }
  return std::nullopt;
}

void ObjectCache::keep(const Unit& unit, const std::string& text, const WorkerBuild& build) const {
  const fs::path place = place_of(unit, text);
  if (!build.is_certain() || fs::exists(place)) return;  // it may be this machine's doing
  const fs::path beside = place.string() + "." + std::to_string(::getpid());
  std::error_code not_moved;
  try {
    write_to(beside, text, build);
    fs::rename(beside, place, not_moved);
  } catch (const std::exception&) {  // no room
    not_moved = std::make_error_code(std::errc::no_space_on_device);
  }
  std::error_code ignored;
  if (not_moved) fs::remove_all(beside, ignored);
}

fs::path ObjectCache::place_of_stub(const Unit& unit) const {
  return folder_ / (unit.chapter + "-" + unit.name + "-stub");
}

std::optional<std::string> ObjectCache::verdict_on_stub(const Unit& unit) const {
  const fs::path place = place_of_stub(unit);
  if (stubs_ == Stubs::judged_again || !fs::exists(place)) return std::nullopt;
  return support::read_text(place);
}

void ObjectCache::keep_verdict_on_stub(const Unit& unit, const std::string& verdict) const {
  if (stubs_ == Stubs::judged_again) return;
  const fs::path place = place_of_stub(unit),
                 beside = place.string() + "." + std::to_string(::getpid());
  support::write_text(beside, verdict);
  fs::rename(beside, place);  // another one's is the same
}

fs::path ObjectCache::place_of_solution(const Unit& unit) const {
  return folder_ / (unit.chapter + "-" + unit.name + "-solution");
}

bool ObjectCache::solution_passes(const Unit& unit) const {
  return fs::exists(place_of_solution(unit));
}

void ObjectCache::keep_that_solution_passes(const Unit& unit) const {
  support::write_text(place_of_solution(unit), "passed");
}

std::unique_ptr<const ObjectCache> objects_of_earlier(const Course& course) {
  try {
    const fs::path folder = course.toolchain.precompiled.parent_path().parent_path() / "compiled" /
                            std::to_string(hash_of_surroundings(course));
    fs::create_directories(folder);
    fs::permissions(folder, fs::perms::owner_all);
    leave_room(folder);
    return std::make_unique<const ObjectCache>(folder, ObjectCache::Stubs::judged_again);
  } catch (const std::exception&) {  // a build that others have made, or a full disk
    return nullptr;
  }
}

}  // namespace tumble::judge
