#pragma once
/// @file
/// Names of people and folders, compared as people do: "é" is one character on most systems and
/// two, "e" and an accent, in what macOS packs. Unicode calls both canonically equivalent.

#include <string>

namespace tumble::judge {

/// One spelling for all that are canonically equivalent (Unicode's NFC). What is not UTF-8 stays as
/// it is, and so does everything where utf8proc is missing.
std::string canonical(const std::string& name);

/// The same without regard to case.
std::string folded(const std::string& name);

/// Of that the letters, their accents and the digits alone: "doejane" for "Doe, Jane".
std::string letters_of(const std::string& name);

/// Whether a name is of ASCII alone, and so has one spelling.
bool is_ascii(const std::string& name);

/// Whether names are compared by what they mean; if not, by their bytes.
bool compares_canonically();

/// What to add about a name that was not found: that another spelling of it would not have been.
/// Empty for ASCII, and where names are compared canonically.
std::string spelling_doubt(const std::string& name);

}  // namespace tumble::judge
