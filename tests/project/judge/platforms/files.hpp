#pragma once
/// @file
/// Files that tests of platforms write and look into.

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "project/judge/attacks/submission.hpp"

namespace tumble::test {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline nlohmann::json json_in(const std::filesystem::path& file) {
  return nlohmann::json::parse(text_of(file));
}

/// With the folders on the way.
inline void write_file(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace tumble::test
