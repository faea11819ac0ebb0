#include "judge/class/archive.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>

#include <cerrno>
#include <functional>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/build/submission.hpp"
#include "judge/class/file_names.hpp"
#include "judge/class/tools.hpp"
#include "judge/sandbox/confined_process.hpp"
#include "judge/sandbox/pipe.hpp"
#include "support/entry.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

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

/// What the process behind the walls has said: entries one after the other, each after its length,
/// and at the end whether it went well.
void read_messages(const std::string& output,
                   const std::function<void(const nlohmann::json&)>& each) {
  for (std::size_t at = 0; at < output.size();) {
    require(at + 4 <= output.size(), "its reader has stopped");
    std::size_t size = 0;
    for (std::size_t i = 4; i-- > 0;) size = size << 8 | static_cast<unsigned char>(output[at + i]);
    require(size <= output.size() - at - 4, "its reader has stopped");
    const auto begin = output.begin() + static_cast<std::ptrdiff_t>(at) + 4;
    each(nlohmann::json::from_msgpack(begin, begin + static_cast<std::ptrdiff_t>(size)));
    at += 4 + size;
  }
}

std::string bytes_in(const nlohmann::json& binary) {
  const auto& bytes = binary.get_binary();
  return {bytes.begin(), bytes.end()};
}

/// Why an archive was not read, or nothing; `each` is called for every entry.
std::string read_archive(const fs::path& archive, const char* what, std::size_t most_output,
                         const Limits& limits,
                         const std::function<void(const nlohmann::json&)>& each) {
  const fs::path program = archive_reader;
  if (program.empty())  // no student's fault
    throw std::runtime_error("cannot read " + archive.string() +
                             ": tumble was built without libarchive");
  // O_NONBLOCK: a pipe of that name would wait for its writer.
  const Descriptor file(::open(archive.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (file.number() < 0) require_working_machine(archive, errno);
  struct stat status = {};
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode))
    return "cannot be read";
  Walls walls = walls_of(program);
  walls.limits.cpu_seconds = limits.cpu_seconds;
  walls.limits.wall_seconds = limits.wall_seconds;
  const Finished finished =
      run_confined({program.string(), what}, {"LC_ALL=C.UTF-8"}, walls, most_output, file.number());
  if (std::string why = why_not_read(finished, archive); !why.empty()) return why;
  std::string refused = "cannot be unpacked: its reader has stopped";
  try {
    read_messages(finished.output, [&](const nlohmann::json& message) {
      if (message.contains("refused"))
        refused = message.at("refused");
      else
        each(message);
    });
  } catch (const std::bad_alloc&) {
    throw;  // here, not behind the walls
  } catch (const std::exception& error) {
    return std::string("cannot be unpacked: ") + error.what();
  }
  return refused;
}

/// The path of what is left out, as far as it is one in this folder.
fs::path harmless(const fs::path& path) {
  fs::path all;
  for (const fs::path& part : path) {
    if (part == ".." || part.is_absolute() || part.string().size() > longest_name) break;
    all /= part;
  }
  return all;
}

/// "a/b.cpp" for "./a/b.cpp"; what leads out of a folder goes on to do so.
std::string without_dots(const fs::path& path) {
  fs::path all;
  for (const fs::path& part : path)
    if (part != ".") all /= part;
  return all.string();
}

/// Keeps an archive's source files, and counts those that it has under one path.
class SourceFiles {
 public:
  /// Of one path the last counts: who adds to an archive puts the new file behind the old one.
  void add(const std::string& path, const std::string& text, Unpacked& to) {
    const std::string place = fs::path(path).lexically_normal().string();
    Entry& known = entries_[place];
    if (++known.count > 1) {
      known.differ = known.differ || to.files.at(known.path) != text;
      to.files.erase(known.path);  // "./a.cpp" is "a.cpp"
    }
    known.path = path;
    to.files[path] = text;
  }

  void note_several(Unpacked& to) const {
    for (const auto& [place, entry] : entries_)
      if (entry.differ)
        to.notes.push_back(place + " is in it " + std::to_string(entry.count) +
                           " times: counted the last");
  }

 private:
  struct Entry {
    std::string path;  ///< the last
    int count = 0;
    bool differ = false;
  };
  std::map<std::string, Entry> entries_;
};

void put_left_out(const EntryLeftOut& entry, const fs::path& to) {
  const fs::path path = harmless(entry.path);
  const bool is_whole = path.filename() == fs::path(entry.path).filename();
  std::error_code there_is_a_file;
  fs::create_directories(to / (is_whole ? path.parent_path() : path), there_is_a_file);
  if (entry.is_work && is_whole && !there_is_a_file && !fs::exists(to / path))
    support::write_text(to / path, "");
}

/// An entry of a class's download: a file with its text, or an empty one that has its name.
void put(const nlohmann::json& entry, const fs::path& to, std::vector<EntryLeftOut>& left_out) {
  if (entry.contains("left_out")) {
    left_out.push_back({without_dots(bytes_in(entry.at("path"))), bytes_in(entry.at("left_out")),
                        entry.at("work")});
    return put_left_out(left_out.back(), to);
  }
  const fs::path file = to / bytes_in(entry.at("path"));
  const std::string text = entry.contains("text") ? bytes_in(entry.at("text")) : "";
  if (support::is_file(file) && entry.contains("text") && support::read_text(file) != text)
    left_out.push_back(
        {without_dots(bytes_in(entry.at("path"))), "has several entries: counted the last", false});
  support::write_text_and_folders(file, text);
}

}  // namespace

std::string why_not_read(const Finished& reader, const fs::path& archive) {
  const auto machine_failed = [&](const std::string& how) {
    throw std::runtime_error("cannot read " + archive.string() + ": " + how);
  };
  if (reader.killed_from_outside)
    machine_failed("its reader was killed: the memory of this machine is used up?");
  // It computes and never waits: if its time of the processor is not used up, it did not get it.
  if (reader.timed_out) machine_failed("its reader did not get the processor: too much runs here");
  if (reader.ending == Ending{false, disk_failed}) machine_failed("a disk that fails?");
  if (reader.ending == Ending{true, SIGXCPU} || reader.ending == Ending{true, SIGKILL})
    return "takes too long to unpack";
  return reader.ending == Ending{false, 0} ? "" : "cannot be unpacked: its reader has crashed";
}

Unpacked unpack(const fs::path& archive) {
  std::error_code unreadable;
  const std::uintmax_t size = fs::file_size(archive, unreadable);
  if (!unreadable && size > largest_archive)
    return {{}, "has " + std::to_string(size) + " bytes: more than 32 MB"};
  Unpacked unpacked;
  SourceFiles sources;
  const Limits limits{.cpu_seconds = 20, .wall_seconds = 60};
  const auto take = [&](const nlohmann::json& entry) {
    if (entry.contains("note"))
      unpacked.notes.push_back(bytes_in(entry.at("note")));
    else if (entry.contains("text"))
      sources.add(bytes_in(entry.at("path")), bytes_in(entry.at("text")), unpacked);
    else
      unpacked.others.push_back(bytes_in(entry.at("path")));
  };
  unpacked.refused = read_archive(archive, "student", 2 * largest_content, limits, take);
  sources.note_several(unpacked);
  return unpacked.refused.empty() ? unpacked : Unpacked{{}, unpacked.refused};
}

std::vector<EntryLeftOut> unpack_class(const fs::path& archive, const fs::path& to) {
  std::vector<EntryLeftOut> left_out;
  const Limits limits{.cpu_seconds = 600, .wall_seconds = 1200};
  const std::string refused =
      read_archive(archive, "class", largest_class_kept + (largest_class_kept >> 2), limits,
                   [&](const nlohmann::json& entry) { put(entry, to, left_out); });
  require(refused.empty(), escaped(archive.string()), " ", escaped(refused));
  return left_out;
}

}  // namespace tumble::judge
