#pragma once
/// @file
/// Text as some editors on Windows write it.

#include <optional>
#include <string>

namespace tumble::judge {

/// The text as UTF-8 if its bytes are UTF-16 with a byte order mark, else nothing. Half a character
/// becomes U+FFFD.
std::optional<std::string> utf8_of_utf16(const std::string& bytes);

}  // namespace tumble::judge
