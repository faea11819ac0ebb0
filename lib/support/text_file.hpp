#pragma once
/// @file
/// Text files that are kept for people: read whole, written whole or not at all.

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

namespace tumble::support {

/// "cannot write grades.csv: No space left on device".
/// @param error of errno; 0 if the system has said nothing
inline std::string failed_at(const std::string& what, const std::filesystem::path& file,
                             int error) {
  return what + " " + file.string() + (error == 0 ? "" : std::string(": ") + std::strerror(error));
}

/// @throws std::runtime_error naming the file if it cannot be read, or is a folder
inline std::string read_text(const std::filesystem::path& file) {
  std::error_code missing;
  if (std::filesystem::is_directory(file, missing))
    throw std::runtime_error("cannot read " + file.string() + ": it is a folder");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(failed_at("cannot read", file, errno));
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What writes a text to a stream: a long one need never be there as a whole.
using TextWriter = std::function<void(std::ostream&)>;

/// Writes into the file as it is.
/// @param named the file for whose sake it is written, for the message
/// @throws std::runtime_error naming the file if it cannot be written
inline void write_in_place(const std::filesystem::path& file, const TextWriter& write,
                           const std::filesystem::path& named) {
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  write(out);
  out.close();
  if (!out) throw std::runtime_error(failed_at("cannot write", named, errno));
}

/// Writes beside the file and then puts it in its place: an interruption, or a full disk, leaves
/// what was there. A device, such as /dev/stdout, is written to.
/// @throws std::runtime_error naming the file if it cannot be written
inline void write_text(const std::filesystem::path& file, const TextWriter& write) {
  namespace fs = std::filesystem;
  std::error_code missing;
  const fs::file_type type = fs::status(file, missing).type();
  if (type == fs::file_type::character || type == fs::file_type::fifo)
    return write_in_place(file, write, file);
  // Each of two writers at the same time has its own file beside it.
  const fs::path beside = file.string() + "." + std::to_string(std::random_device()()) + ".new";
  try {
    write_in_place(beside, write, file);
    fs::rename(beside, file);
  } catch (...) {
    fs::remove(beside, missing);
    throw;
  }
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  write_text(file, [&](std::ostream& out) { out << text; });
}

/// The same, in folders that need not be there.
inline void write_text_and_folders(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  write_text(file, text);
}

}  // namespace tumble::support
