/// @file
/// The process that reads a stranger's archive: it stands behind walls, takes the archive from
/// standard input, and writes the source files, or why it refuses, to standard output.
#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/build/submission.hpp"
#include "judge/class/archive.hpp"

namespace tumble::judge {

namespace {

/// Leads a path out of the folder that it is unpacked in?
bool leads_out(const fs::path& path) {
  return path.is_absolute() || path.string().find('\\') != std::string::npos ||
         std::find(path.begin(), path.end(), "..") != path.end();
}

/// An open archive in memory.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : archive_(archive_read_new(), archive_read_free) {
    archive_read_support_filter_all(archive_.get());
    archive_read_support_format_zip(archive_.get());
    archive_read_support_format_tar(archive_.get());
    require_ok(archive_read_open_memory(archive_.get(), bytes.data(), bytes.size()));
  }

  /// The next entry, null at the end.
  archive_entry* next() {
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(archive_.get(), &entry);
    if (status == ARCHIVE_EOF) return nullptr;
    require_ok(status);
    if (++entries_ > most_entries)
      throw Refused("has more than " + std::to_string(most_entries) + " entries");
    return entry;
  }

  /// The content of the current entry, up to what a source file may have.
  std::string content() {
    std::string text, part(1 << 16, '\0');
    for (;;) {
      const la_ssize_t got = archive_read_data(archive_.get(), part.data(), part.size());
      if (got < 0) require_ok(static_cast<int>(got));
      if (got <= 0) return text;
      total_ += static_cast<std::size_t>(got);
      if (total_ > largest_content) throw Refused("unpacks to more than 256 MB");
      if (text.size() <= largest_submission) text.append(part, 0, static_cast<std::size_t>(got));
    }
  }

 private:
  void require_ok(int status) const {
    if (status >= ARCHIVE_WARN) return;
    const char* why = archive_error_string(archive_.get());
    throw Refused(std::string("cannot be unpacked: ") + (why ? why : "it is damaged"));
  }

  std::unique_ptr<archive, int (*)(archive*)> archive_;
  std::size_t entries_ = 0, total_ = 0;
};

/// The path of an entry that may be unpacked.
std::string checked_path(archive_entry* entry) {
  const char* name = archive_entry_pathname(entry);
  if (!name || !*name) throw Refused("has an entry without a name");
  const std::string path = name;
  if (leads_out(path)) throw Refused("has a path that leads out of it: " + path);
  if (archive_entry_hardlink(entry) || archive_entry_filetype(entry) == AE_IFLNK)
    throw Refused("has a link in it: " + path);
  const auto type = archive_entry_filetype(entry);
  if (type != AE_IFREG && type != AE_IFDIR)
    throw Refused("has in it what is neither a file nor a folder: " + path);
  if (archive_entry_is_encrypted(entry)) throw Refused("is encrypted");
  return path;
}

Unpacked unpack_bytes(const std::string& bytes) {
  Unpacked result;
  try {
    Reader reader(bytes);
    while (archive_entry* entry = reader.next()) {
      const std::string path = checked_path(entry);
      std::string content = reader.content();
      if (path.ends_with(".cpp")) result.files[path] = std::move(content);
    }
  } catch (const Refused& why) {
    return {{}, why.what()};
  }
  return result;
}

/// A message of the files and the refusal.
std::vector<std::uint8_t> message_of(const Unpacked& unpacked) {
  nlohmann::json j{{"refused", unpacked.refused}, {"files", nlohmann::json::object()}};
  for (const auto& [path, text] : unpacked.files)
    j["files"][path] = nlohmann::json::binary({text.begin(), text.end()});
  return nlohmann::json::to_msgpack(j);
}

}  // namespace

}  // namespace tumble::judge

int main() {
  const std::string bytes{std::istreambuf_iterator<char>(std::cin), {}};
  const auto message = tumble::judge::message_of(tumble::judge::unpack_bytes(bytes));
  std::cout.write(reinterpret_cast<const char*>(message.data()),
                  static_cast<std::streamsize>(message.size()));
  return std::cout.flush() ? 0 : 1;
}
