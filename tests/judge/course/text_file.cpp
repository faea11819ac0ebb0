#include "judge/course/text_file.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace tumble::judge {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

namespace {

void write_in_place(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

void write_text(const fs::path& file, const std::string& text) {
  std::error_code missing;
  const fs::file_type type = fs::status(file, missing).type();
  if (type == fs::file_type::character || type == fs::file_type::fifo)
    return write_in_place(file, text);  // /dev/stdout stays what it is
  const fs::path beside = file.string() + ".new";
  fs::remove(beside);  // a link there would lead elsewhere
  write_in_place(beside, text);
  fs::rename(beside, file);
}

void write_text_and_folders(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  write_text(file, text);
}

}  // namespace tumble::judge
