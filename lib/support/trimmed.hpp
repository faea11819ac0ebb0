#pragma once
/// @file
/// Texts without the blanks around them.

#include <string>

namespace tumble::support {

/// "1.1" of " 1.1\n".
inline std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace tumble::support
