#include "judge/class/archive.hpp"

#include <fcntl.h>

#include <nlohmann/json.hpp>

#include "judge/sandbox/confined_process.hpp"
#include "judge/sandbox/pipe.hpp"

namespace tumble::judge {

namespace {

/// Reads, computes, writes to its pipe, and nothing else.
Walls walls_of(const fs::path& program) {
  Walls walls;
  walls.folder = "/";
  walls.limits.cpu_seconds = 20;
  walls.limits.wall_seconds = 60;
  walls.limits.memory_bytes = 1ull << 30;
  walls.files.read = {"/usr", "/lib", "/lib64", "/etc/ld.so.cache", program};
  walls.other_user = others_may_enter(program.parent_path());
  walls.system_calls = CallRules::sanitizer;
  return walls;
}

/// What the process behind the walls says.
Unpacked read_message(const std::string& message) {
  const nlohmann::json j = nlohmann::json::from_msgpack(message);
  Unpacked unpacked{{}, j.at("refused")};
  for (const auto& [path, text] : j.at("files").items()) {
    const auto& bytes = text.get_binary();
    unpacked.files[path] = std::string(bytes.begin(), bytes.end());
  }
  return unpacked;
}

}  // namespace

Unpacked unpack(const fs::path& archive) {
#ifdef TUMBLE_UNPACK
  const fs::path program = TUMBLE_UNPACK;
  const Descriptor file(::open(archive.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
  if (file.number() < 0) return {{}, "cannot be read"};
  if (fs::file_size(archive) > largest_archive)
    return {{}, "has " + std::to_string(fs::file_size(archive)) + " bytes: more than 32 MB"};
  const Finished finished = run_confined({program.string()}, {"LC_ALL=C.UTF-8"}, walls_of(program),
                                         2 * largest_content, file.number());
  if (finished.timed_out) return {{}, "takes too long to unpack"};
  if (finished.ending != Ending{false, 0})
    return {{}, "cannot be unpacked: its reader has crashed"};
  try {
    return read_message(finished.output);
  } catch (const nlohmann::json::exception& error) {
    return {{}, std::string("cannot be unpacked: ") + error.what()};
  }
#else
  return {{},
          "cannot be unpacked: " + archive.string() + ", as tumble was built without libarchive"};
#endif
}

}  // namespace tumble::judge
