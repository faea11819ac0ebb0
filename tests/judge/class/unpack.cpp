/// @file
/// The process that reads a stranger's archive: it stands behind walls, takes the archive from
/// standard input, and writes what is in it, or why it refuses, to standard output: messages, each
/// after its length in four bytes.
///
///     tumble_unpack student    refuses as a whole what could do harm
///     tumble_unpack class      a platform's download: leaves such entries out, and says so
#include <archive.h>
#include <archive_entry.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "judge/build/submission.hpp"
#include "judge/class/archive.hpp"
#include "judge/class/file_kinds.hpp"
#include "judge/class/unreadable_archive.hpp"

namespace tumble::judge {

namespace {

using nlohmann::json;

/// What standard input comes from cannot be read.
struct DiskFailed : std::exception {};

/// More than is unpacked at all, in however many archives it is.
struct TooMuch : Refused {
  using Refused::Refused;
};

/// An archive is refused for what one entry is.
struct BadEntry : Refused {
  BadEntry(const std::string& archive_has, const std::string& entry_is, const std::string& path)
      : Refused(archive_has + ": " + path), is(entry_is) {}
  std::string is;  ///< for who leaves out the entry alone
};

/// What one kind of archive may have in it.
struct Allowed {
  std::size_t entries = most_entries, content = largest_content, kept = largest_content;
  const char* too_much = "unpacks to more than 256 MB";
  bool is_class = false;
};

const Allowed whole_class{most_class_entries, largest_class, largest_class_kept,
                          "unpacks to more than 8 GB: unpack it yourself and give the folder",
                          true};

/// What was used of it so far, by the archive and by those in it.
struct Used {
  std::size_t entries = 0, content = 0, kept = 0;
};

json bytes_of(const std::string& text) { return json::binary({text.begin(), text.end()}); }

void write_message(const json& message) {
  const std::vector<std::uint8_t> body = json::to_msgpack(message);
  for (std::size_t i = 0; i < 4; ++i) std::cout.put(static_cast<char>(body.size() >> 8 * i & 0xff));
  std::cout.write(reinterpret_cast<const char*>(body.data()),
                  static_cast<std::streamsize>(body.size()));
}

/// Leads a path out of the folder that it is unpacked in?
bool leads_out(const fs::path& path) {
  return path.is_absolute() || path.string().find('\\') != std::string::npos ||
         std::find(path.begin(), path.end(), "..") != path.end();
}

/// The first bytes of standard input, a file, of which none counts as read.
std::string start_of_input() {
  std::string bytes(known_start, '\0');
  const ssize_t got = ::read(0, bytes.data(), bytes.size());
  if (got < 0 || ::lseek(0, 0, SEEK_SET) != 0) throw DiskFailed();
  bytes.resize(static_cast<std::size_t>(got));
  return bytes;
}

/// An open archive: standard input, or bytes in memory.
class Reader {
 public:
  Reader(const Allowed& allowed, Used& used) : Reader(&allowed, &used) {
    constexpr std::size_t block = 1 << 16;
    start_ = start_of_input();
    require_ok(archive_read_open_fd(archive_.get(), 0, block));
  }
  Reader(const Allowed& allowed, Used& used, const std::string& bytes) : Reader(&allowed, &used) {
    start_ = bytes.substr(0, known_start);
    require_ok(archive_read_open_memory(archive_.get(), bytes.data(), bytes.size()));
  }

  /// The next entry, null at the end.
  archive_entry* next() {
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(archive_.get(), &entry);
    if (status == ARCHIVE_EOF) return nullptr;
    require_ok(status);
    if (++used_->entries > allowed_->entries)
      throw TooMuch("has more than " + std::to_string(allowed_->entries) + " entries");
    return entry;
  }

  /// The content of the current entry, up to `most` bytes and one more block.
  std::string content(std::size_t most) {
    std::string text, part(1 << 16, '\0');
    for (;;) {
      const la_ssize_t got = archive_read_data(archive_.get(), part.data(), part.size());
      if (got < 0) refuse();  // a mere warning says that a checksum is wrong
      if (got == 0) return text;
      used_->content += static_cast<std::size_t>(got);
      if (used_->content > allowed_->content) throw TooMuch(allowed_->too_much);
      if (text.size() <= most) text.append(part, 0, static_cast<std::size_t>(got));
    }
  }

 private:
  Reader(const Allowed* allowed, Used* used)
      : allowed_(allowed), used_(used), archive_(archive_read_new(), archive_read_free) {
    // Not all filters that there are: some start a program of that name.
    archive_read_support_filter_gzip(archive_.get());
    archive_read_support_filter_bzip2(archive_.get());
    archive_read_support_filter_xz(archive_.get());
    archive_read_support_filter_zstd(archive_.get());
    archive_read_support_format_zip(archive_.get());
    archive_read_support_format_tar(archive_.get());
    archive_read_support_format_7zip(archive_.get());
  }

  void require_ok(int status) const {
    if (status < ARCHIVE_WARN) refuse();
  }

  [[noreturn]] void refuse() const {
    const int error = archive_errno(archive_.get());
    if (error == EIO || error == ESTALE || error == ETIMEDOUT) throw DiskFailed();
    const char* words = archive_error_string(archive_.get());
    throw Refused(why_unreadable(start_, words ? words : ""));
  }

  const Allowed* allowed_;
  Used* used_;
  std::string start_;  ///< its first bytes
  std::unique_ptr<archive, int (*)(archive*)> archive_;
};

/// No two entries of an archive may be a file and a folder of one name.
class Names {
 public:
  void add(const fs::path& path, bool is_folder) {
    const fs::path name = path.lexically_normal();
    for (fs::path above = name.parent_path(); !above.empty(); above = above.parent_path())
      add_one(above, true);
    if (name.has_filename()) add_one(name, is_folder);
  }

 private:
  void add_one(const fs::path& name, bool is_folder) {
    if ((is_folder ? files_ : folders_).contains(name.string()))
      throw Refused("has both a file and a folder called " + name.string());
    (is_folder ? folders_ : files_).insert(name.string());
  }

  std::set<std::string> files_, folders_;
};

std::string path_of(archive_entry* entry) {
  const char* name = archive_entry_pathname(entry);
  if (!name) name = archive_entry_pathname_utf8(entry);
  if (!name || !*name) throw Refused("has an entry without a name");
  return name;
}

void require_short(const std::string& path) {
  if (path.size() > longest_path)
    throw Refused("has a path of " + std::to_string(path.size()) + " bytes: " + path.substr(0, 60) +
                  "…");
  for (const fs::path& part : fs::path(path))
    if (part.string().size() > longest_name)
      throw Refused("has a name of " + std::to_string(part.string().size()) +
                    " bytes: " + part.string().substr(0, 60) + "…");
}

/// The path of an entry that may be unpacked.
std::string checked_path(archive_entry* entry) {
  const std::string path = path_of(entry);
  if (leads_out(path))
    throw BadEntry("has a path that leads out of it", "leads out of the archive", path);
  if (archive_entry_hardlink(entry) || archive_entry_filetype(entry) == AE_IFLNK)
    throw BadEntry("has a link in it", "is a link", path);
  const auto type = archive_entry_filetype(entry);
  if (type != AE_IFREG && type != AE_IFDIR)
    throw BadEntry("has in it what is neither a file nor a folder",
                   "is neither a file nor a folder", path);
  if (archive_entry_is_encrypted(entry)) throw Refused("is encrypted");
  require_short(path);
  return path;
}

/// How much of a file is of interest: none of those that are neither sources nor archives.
std::size_t wanted_bytes(const std::string& file, bool is_class) {
  if (!source_stem(file).empty()) return largest_submission;
  if (!archive_stem(file).empty()) return largest_archive;
  return is_class && file == "submission_metadata.yml" ? largest_submission << 4 : 0;
}

/// What is said of an entry that is left out of a class's download.
json left_out(archive_entry* entry, const std::string& why) {
  const char* name = archive_entry_pathname(entry);
  const std::string path = name ? name : "";
  const bool is_work = archive_entry_filetype(entry) != AE_IFDIR &&
                       wanted_bytes(fs::path(path).filename().string(), false) > 0;
  return {{"left_out", bytes_of(why)}, {"path", bytes_of(path)}, {"work", is_work}};
}

/// Reads an archive, and those in it.
class Unpacking {
 public:
  explicit Unpacking(const Allowed& allowed) : allowed_(allowed) {}

  void read() {
    Reader reader(allowed_, used_);
    read_all(reader, "", write_message);
  }

 private:
  using Say = std::function<void(const json&)>;

  void read_all(Reader& reader, const std::string& within, const Say& say) {
    Names names;
    while (archive_entry* entry = reader.next()) {
      try {
        const std::string path = checked_path(entry);
        names.add(path, archive_entry_filetype(entry) == AE_IFDIR);
        if (archive_entry_filetype(entry) == AE_IFREG) add(reader, within, path, say);
      } catch (const TooMuch&) {
        throw;
      } catch (const BadEntry& why) {
        if (!allowed_.is_class) throw;
        say(left_out(entry, why.is));
      } catch (const Refused& why) {
        if (!allowed_.is_class) throw;
        say(left_out(entry, why.what()));
      }
    }
  }

  void add(Reader& reader, const std::string& within, const std::string& path, const Say& say) {
    const std::string file = fs::path(path).filename().string();
    const std::size_t wanted = wanted_bytes(file, allowed_.is_class);
    const bool read = wanted > 0 || !allowed_.is_class;  // the rest of a student's may be a bomb
    const std::string content = read ? reader.content(wanted) : "";
    if (!allowed_.is_class && !archive_stem(file).empty()) {
      add_archive(within, path, content, say);
    } else if (wanted > 0) {
      keep(content.size());
      say({{"path", bytes_of(within + path)}, {"text", bytes_of(content)}});
    } else {
      say({{"path", bytes_of(within + path)}});
    }
  }

  /// An archive in the archive; one in that is too deep.
  void add_archive(const std::string& within, const std::string& path, const std::string& content,
                   const Say& say) {
    const auto note = [&](const std::string& why) {
      say({{"path", bytes_of(within + path)}});
      say({{"note", bytes_of(within + path + " in it " + why)}});
    };
    if (is_clutter(fs::path(path).filename().string())) return;
    if (!within.empty()) return note("was not read: it is an archive in an archive in an archive");
    if (content.size() > largest_archive) return note("has more than 32 MB");
    try {
      Reader inner(allowed_, used_, content);
      std::vector<json> found;  // said only if all of it is harmless
      read_all(inner, path + "/", [&](const json& message) { found.push_back(message); });
      for (const json& message : found) say(message);
    } catch (const TooMuch&) {
      throw;
    } catch (const Refused& why) {
      note(why.what());
    }
  }

  void keep(std::size_t bytes) {
    used_.kept += bytes;
    if (used_.kept > allowed_.kept)
      throw TooMuch("has more than 512 MB in it: unpack it yourself and give the folder");
  }

  const Allowed& allowed_;
  Used used_;
};

}  // namespace

}  // namespace tumble::judge

int main(int argc, char** argv) {
  using namespace tumble::judge;
  std::setlocale(LC_CTYPE, "C.UTF-8");  // names that are not ASCII
  const Allowed student;
  std::string refused;
  try {
    Unpacking(argc > 1 && std::string(argv[1]) == "class" ? whole_class : student).read();
  } catch (const Refused& why) {
    refused = why.what();
  } catch (const DiskFailed&) {
    return disk_failed;
  }
  write_message({{"refused", refused}});
  return std::cout.flush() ? 0 : 1;
}
