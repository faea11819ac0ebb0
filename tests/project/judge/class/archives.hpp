#pragma once
/// @file
/// Archives as students, and those who mean harm, hand them in.

#include <archive.h>
#include <archive_entry.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tumble/core/require.hpp"

namespace tumble::test {

/// An entry; what its link leads to, if it is one.
struct Entry {
  std::string path, content;
  unsigned type = AE_IFREG;
  std::string link = "";
};

/// Writes a .zip, or a .tar.gz, by the name's ending.
inline void write_archive(const std::filesystem::path& file, const std::vector<Entry>& entries) {
  archive* out = archive_write_new();
  if (file.extension() == ".zip") {
    archive_write_set_format_zip(out);
  } else {
    archive_write_add_filter_gzip(out);
    archive_write_set_format_pax_restricted(out);
  }
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

}  // namespace tumble::test
