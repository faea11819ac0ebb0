#pragma once
/// @file
/// The one file that a student hands in for a unit.

#include <filesystem>
#include <stdexcept>
#include <string>

#include "judge/build/source_text.hpp"
#include "judge/build/text_encoding.hpp"

namespace tumble::judge {

/// A file that is not looked at any further; the message says why.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What cannot be read because of this machine is not what a student has not handed in.
/// @param error of errno
/// @throws std::runtime_error if it is the machine's: too many open files, no memory, a disk that
///         fails, no permission
void require_working_machine(const std::filesystem::path& path, int error);

/// The text of a regular file (no link, no pipe, no device), without NUL and as UTF-8: of other
/// encodings decoded() makes it.
/// @throws Refused if it is missing, empty, too large, or anything else
/// @throws std::runtime_error if this machine cannot read it: a disk that fails, too many open
///         files, no permission
std::string read_submission(const std::filesystem::path& path);

/// The same, and in which encoding it was.
DecodedText read_decoded_submission(const std::filesystem::path& path);

}  // namespace tumble::judge
