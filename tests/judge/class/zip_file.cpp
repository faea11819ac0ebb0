#include "judge/class/zip_file.hpp"

#include <fcntl.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/build/work_folder.hpp"
#include "judge/class/tools.hpp"
#include "judge/sandbox/confined_process.hpp"
#include "judge/sandbox/pipe.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

/// The texts as one message; paths need not be UTF-8.
std::string message_of_texts(const std::map<std::string, std::string>& texts) {
  using nlohmann::json;
  json files = json::array();
  for (const auto& [path, text] : texts)
    files.push_back(
        {json::binary({path.begin(), path.end()}), json::binary({text.begin(), text.end()})});
  const std::vector<std::uint8_t> message = json::to_msgpack(files);
  return {message.begin(), message.end()};
}

/// Reads, computes, writes to its pipe, as the reader of archives.
Walls walls_around_packing(const fs::path& program) {
  Walls walls;
  walls.folder = "/";
  walls.limits.cpu_seconds = 120;
  walls.limits.wall_seconds = 300;
  walls.limits.memory_bytes = 1ull << 30;
  walls.files.read = {"/usr", "/lib", "/lib64", "/etc/ld.so.cache", program};
  walls.other_user = others_may_enter(program.parent_path());
  walls.system_calls = CallRules::sanitizer;
  return walls;
}

}  // namespace

bool can_write_zip() { return *archive_writer != '\0'; }

void write_zip(const std::filesystem::path& file, const std::map<std::string, std::string>& texts) {
  if (!can_write_zip())
    throw std::runtime_error("cannot write " + file.string() +
                             ": tumble was built without libarchive");
  const WorkFolder work;
  const fs::path message = work.path() / "texts", program = archive_writer;
  support::write_text(message, message_of_texts(texts));
  const Descriptor in(::open(message.c_str(), O_RDONLY | O_CLOEXEC));
  constexpr std::size_t most = 512u << 20;
  const Finished finished = run_confined({program.string()}, {"LC_ALL=C.UTF-8"},
                                         walls_around_packing(program), most, in.number());
  if (finished.timed_out || finished.ending != Ending{false, 0})
    throw std::runtime_error("cannot write " + file.string() + ": " +
                             finished.output.substr(0, 200));
  support::write_text(file, finished.output);
}

}  // namespace tumble::judge
