/// @file
/// A folder of inputs as one text file, and back: `fuzz_corpus pack FOLDER FILE`, `fuzz_corpus
/// unpack FILE FOLDER`. An input is a line; what is not a printable letter of ASCII is written
/// \xHH, the backslash too.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

namespace {

constexpr std::string_view digits = "0123456789ABCDEF";

std::string escaped(const std::string& bytes) {
  std::string line;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F && c != '\\')
      line += c;
    else
      line += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
  }
  return line;
}

std::string unescaped(const std::string& line) {
  std::string bytes;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\\') {
      bytes += line[i];
      continue;
    }
    const std::size_t high = digits.find(line.at(i + 2)), low = digits.find(line.at(i + 3));
    if (line[i + 1] != 'x' || high == digits.npos || low == digits.npos)
      throw std::runtime_error("a backslash without xHH");
    bytes += static_cast<char>(16 * high + low);
    i += 3;
  }
  return bytes;
}

/// Sorted, and each once, so that a new find is a new line in a comparison.
void pack(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::set<std::string> lines;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    lines.insert(escaped(std::string(std::istreambuf_iterator<char>(in), {})));
  }
  std::ofstream out(file, std::ios::binary);
  for (const std::string& line : lines) out << line << '\n';
  if (!out.flush()) throw std::runtime_error(file.string() + " cannot be written");
}

void unpack(const std::filesystem::path& file, const std::filesystem::path& folder) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file.string() + " cannot be read");
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  int number = 0;
  for (std::string line; std::getline(in, line);)
    std::ofstream(folder / std::to_string(++number), std::ios::binary) << unescaped(line);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc == 4 ? argv[1] : "";
  try {
    if (mode == "pack")
      pack(argv[2], argv[3]);
    else if (mode == "unpack")
      unpack(argv[2], argv[3]);
    else
      throw std::runtime_error("usage: fuzz_corpus pack FOLDER FILE | unpack FILE FOLDER");
  } catch (const std::exception& error) {
    std::cerr << "fuzz_corpus: " << error.what() << '\n';
    return 1;
  }
}
