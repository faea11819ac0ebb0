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

/// Why this text is not compiled: "is empty", "is not UTF-8 text: see line 3"; empty if it is.
std::string reason_to_refuse(const std::string& text);

}  // namespace tumble::judge
