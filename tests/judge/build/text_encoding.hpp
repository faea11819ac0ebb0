#pragma once
/// @file
/// The encodings in which editors save a student's file.

#include <string>

namespace tumble::judge {

/// A file's text as UTF-8, and what it was.
struct DecodedText {
  std::string text;
  std::string was;  ///< "UTF-16", "Windows-1252"; empty if it was UTF-8
};

/// UTF-16 is known by its byte order mark. In any other text a byte that is not UTF-8 is read as
/// Windows-1252, the rest as UTF-8: files that two editors have saved are both. A text with a NUL
/// is no text, and stays as it is.
DecodedText decoded(const std::string& bytes);

}  // namespace tumble::judge
