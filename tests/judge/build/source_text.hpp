#pragma once
/// @file
/// What a text has to be in order to be compiled as a student's file.

#include <cstddef>
#include <string>

namespace tumble::judge {

/// The largest source file that is read, in bytes: ten thousand lines.
inline constexpr std::size_t largest_submission = 256 << 10;

/// Why a file of `size` bytes is not read: "has … bytes: …"; empty if it is.
std::string too_large(std::size_t size);

/// The length of the UTF-8 character at `at`, 0 if there is none or it is NUL (Unicode 15, table
/// 3-7: no overlong forms, no surrogates, nothing above U+10FFFF).
std::size_t character_length(const std::string& text, std::size_t at);

/// Why this text is not compiled: "is empty", "has a NUL byte in line 3: …"; empty if it is.
std::string reason_to_refuse(const std::string& text);

}  // namespace tumble::judge
