#pragma once
/// @file
/// Archives as students, and those who mean harm, hand them in.

#include <archive.h>
#include <archive_entry.h>

#include <cctype>
#include <clocale>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "project/harness/temporary_folder.hpp"
#include "tumble/core/require.hpp"

namespace tumble::test {

/// An entry; what its link leads to, if it is one.
struct Entry {
  std::string path, content;
  unsigned type = AE_IFREG;
  std::string link = "";
};

/// Sets format and filter by the name's ending: .zip, .7z, .tar, .tar.bz2, .tar.xz, .tar.zst, or a
/// .tar.gz.
inline void set_format(archive* out, std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (name.ends_with(".zip")) {
    archive_write_set_format_zip(out);
    return;
  }
  if (name.ends_with(".7z")) {
    archive_write_set_format_7zip(out);
    return;
  }
  if (name.ends_with(".bz2")) archive_write_add_filter_bzip2(out);
  if (name.ends_with(".xz")) archive_write_add_filter_xz(out);
  if (name.ends_with(".zst")) archive_write_add_filter_zstd(out);
  if (name.ends_with("gz")) archive_write_add_filter_gzip(out);
  archive_write_set_format_pax_restricted(out);
}

/// Writes an archive of the kind that its name says.
inline void write_archive(const std::filesystem::path& file, const std::vector<Entry>& entries) {
  std::setlocale(LC_CTYPE, "C.UTF-8");  // 7z keeps characters, not bytes
  archive* out = archive_write_new();
  set_format(out, file.filename().string());
  require(archive_write_open_filename(out, file.c_str()) == ARCHIVE_OK, "cannot write ",
          file.string());
  for (const Entry& each : entries) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, each.path.c_str());
    archive_entry_set_filetype(entry, each.type);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_size(entry, static_cast<la_int64_t>(each.content.size()));
    if (each.type == AE_IFLNK) archive_entry_set_symlink(entry, each.link.c_str());
    if (each.type == AE_IFREG && !each.link.empty())
      archive_entry_set_hardlink(entry, each.link.c_str());
    archive_write_header(out, entry);
    archive_write_data(out, each.content.data(), each.content.size());
    archive_entry_free(entry);
  }
  archive_write_close(out);
  archive_write_free(out);
}

/// The bytes of an archive, to put into another one.
inline std::string archive_bytes(const std::string& name, const std::vector<Entry>& entries) {
  const TemporaryFolder folder;
  write_archive(folder.path() / name, entries);
  std::ifstream in(folder.path() / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The text as an editor on Windows may save it: UTF-16 with a byte order mark.
inline std::string utf16(const std::string& ascii) {
  std::string bytes = "\xff\xfe";
  for (const char c : ascii) (bytes += c) += '\0';
  return bytes;
}

}  // namespace tumble::test
