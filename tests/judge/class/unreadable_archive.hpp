#pragma once
/// @file
/// What is said of an archive that its reader cannot read. The reader is a program of its own:
/// nothing but the standard library is needed here.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace tumble::judge {

/// So many bytes tell what kind of file it is.
inline constexpr std::size_t known_start = 8;

/// The kind of file that begins so, with its article; empty if we know none.
inline std::string kind_of_file(const std::string& start) {
  struct Kind {
    std::string_view start, name;
  };
  using namespace std::string_view_literals;
  static constexpr std::array<Kind, 8> kinds = {{{"Rar!"sv, "a RAR archive"sv},
                                                 {"MSCF"sv, "a CAB archive"sv},
                                                 {"LZIP"sv, "an lzip file"sv},
                                                 {"\x04\x22\x4d\x18"sv, "an lz4 file"sv},
                                                 {"\x1f\x9d"sv, "a file of `compress`"sv},
                                                 {"%PDF"sv, "a PDF"sv},
                                                 {"<!DOCTYP"sv, "a web page"sv},
                                                 {"<html"sv, "a web page"sv}}};
  for (const Kind& kind : kinds)
    if (start.starts_with(kind.start)) return std::string(kind.name);
  return "";
}

/// "is empty", "is a RAR archive, and cannot be read here: ask for a .zip", "is damaged (…)".
/// @param start its first bytes
/// @param words of the library that reads archives
inline std::string why_unreadable(const std::string& start, const std::string& words) {
  const auto says = [&](const char* part) { return words.find(part) != std::string::npos; };
  if (start.empty()) return "is empty";
  if (const std::string kind = kind_of_file(start); !kind.empty())
    return "is " + kind + ", and cannot be read here: ask for a .zip";
  if (says("Unrecognized archive format")) return "is no archive, whatever its name says";
  const std::string in_parentheses = words.empty() ? "" : " (" + words + ")";
  if (says("ncrypt") || says("assphrase")) return "is encrypted" + in_parentheses;
  if (says("nsupported")) return "is packed in a way that cannot be read here" + in_parentheses;
  if (says("allocate")) return "needs too much memory to be unpacked" + in_parentheses;
  return "is damaged" + in_parentheses;
}

}  // namespace tumble::judge
