/// @file
/// The process that writes a zip: it takes a message of paths and texts from standard input, and
/// writes the archive to standard output. The same texts give the same bytes.
#include <archive.h>
#include <archive_entry.h>

#include <clocale>
#include <ctime>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace {

constexpr std::time_t moment = 315532800;  // the first that a zip can say: 1980

void require_ok(archive* out, int status) {
  if (status < ARCHIVE_WARN) throw std::runtime_error(archive_error_string(out));
}

void add(archive* out, const std::string& path, const std::string& text) {
  archive_entry* entry = archive_entry_new();
  archive_entry_set_pathname(entry, path.c_str());
  archive_entry_set_filetype(entry, AE_IFREG);
  archive_entry_set_perm(entry, 0644);
  archive_entry_set_mtime(entry, moment, 0);
  archive_entry_set_size(entry, static_cast<la_int64_t>(text.size()));
  require_ok(out, archive_write_header(out, entry));
  if (archive_write_data(out, text.data(), text.size()) < 0) require_ok(out, ARCHIVE_FATAL);
  archive_entry_free(entry);
}

void write_zip(const nlohmann::json& files) {
  archive* out = archive_write_new();
  require_ok(out, archive_write_set_format_zip(out));
  archive_write_set_options(out, "zip:hdrcharset=UTF-8");
  archive_write_set_bytes_in_last_block(out, 1);  // nothing behind the end
  require_ok(out, archive_write_open_fd(out, 1));
  for (const nlohmann::json& file : files) {
    const auto& path = file.at(0).get_binary();
    const auto& text = file.at(1).get_binary();
    add(out, {path.begin(), path.end()}, {text.begin(), text.end()});
  }
  require_ok(out, archive_write_close(out));
  archive_write_free(out);
}

}  // namespace

int main() {
  std::setlocale(LC_CTYPE, "C.UTF-8");
  try {
    const std::string bytes{std::istreambuf_iterator<char>(std::cin), {}};
    write_zip(nlohmann::json::from_msgpack(bytes));
  } catch (const std::exception& error) {
    std::cerr << error.what();
    return 1;
  }
  return 0;
}
