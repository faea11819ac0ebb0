#pragma once
/// @file
/// A field of comma-separated values.
///
/// Source: RFC 4180.

#include <string>

namespace tumble::support {

/// The text, quoted where it has a comma, a quote or a line end.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace tumble::support
