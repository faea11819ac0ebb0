/// @file
/// A figure's module as a script: pages from disk may load scripts, and nothing else.
/// tumble_embed FILE.wasm.gz NAME SCRIPT.js

#include <exception>
#include <iostream>

#include "support/text_file.hpp"

namespace {

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: tumble_embed FILE.wasm.gz NAME SCRIPT.js\n";
    return 2;
  }
  try {
    tumble::support::write_text_and_folders(
        argv[3], "tumbleMoving.arrived(\"" + std::string(argv[2]) + "\", \"" +
                     base64(tumble::support::read_text(argv[1])) + "\");\n");
  } catch (const std::exception& error) {
    std::cerr << "tumble_embed: " << error.what() << '\n';
    return 2;
  }
}
