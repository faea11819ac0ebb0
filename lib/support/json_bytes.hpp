#pragma once
/// @file
/// Any bytes inside JSON: a text that need not be UTF-8, in a message that is written as
/// MessagePack.

#include <nlohmann/json.hpp>
#include <string>

namespace tumble::support {

inline nlohmann::json bytes_of(const std::string& text) {
  return nlohmann::json::binary({text.begin(), text.end()});
}

/// @throws nlohmann::json::type_error if these are no bytes
inline std::string text_in(const nlohmann::json& bytes) {
  const auto& binary = bytes.get_binary();
  return {binary.begin(), binary.end()};
}

}  // namespace tumble::support
