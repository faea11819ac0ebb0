#pragma once
/// @file
/// What a file is, by its name, however its student has spelt it. The reader of archives, a program
/// of its own, asks as well: nothing but the standard library is needed here.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace tumble::judge {

/// The text with A … Z in lower case; nothing else is changed, whatever the locale.
inline std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// "meyer" for meyer.tar.gz or Meyer.ZIP, in its own spelling; empty if `file` has none of these
/// endings.
template <std::size_t n>
std::string without_ending(const std::string& file, const std::array<std::string_view, n>& list) {
  const std::string lower = lower_case(file);
  std::string_view longest;
  for (const std::string_view ending : list)
    if (lower.ends_with(ending) && lower.size() > ending.size() && ending.size() > longest.size())
      longest = ending;
  return longest.empty() ? "" : file.substr(0, file.size() - longest.size());
}

/// The name of an archive that can be read, without its ending; empty for anything else.
inline std::string archive_stem(const std::string& file) {
  static constexpr std::array<std::string_view, 12> endings = {
      ".zip", ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tbz2",
      ".tbz", ".7z",  ".tar.xz", ".txz", ".tar.zst", ".tzst"};
  return without_ending(file, endings);
}

/// The name of an archive that cannot be read, without its ending; empty for anything else.
inline std::string foreign_archive_stem(const std::string& file) {
  static constexpr std::array<std::string_view, 36> endings = {
      ".rar",   ".zipx", ".jar",  ".war", ".cpio", ".tar.lz", ".tar.lz4", ".tar.lzo", ".tar.lzma",
      ".tar.z", ".tlz",  ".taz",  ".lzh", ".lha",  ".arj",    ".arc",     ".zoo",     ".cab",
      ".ace",   ".sit",  ".sitx", ".xar", ".wim",  ".lz",     ".lz4",     ".lzo",     ".lzma",
      ".z",     ".gz",   ".bz2",  ".xz",  ".zst",  ".iso",    ".dmg",     ".001",     ".z01"};
  return archive_stem(file).empty() ? without_ending(file, endings) : "";
}

/// The name of a C++ source file without its ending; empty for anything else. An editor or a mail
/// program may have added .txt.
inline std::string source_stem(const std::string& file) {
  static constexpr std::array<std::string_view, 2> endings = {".cpp", ".cpp.txt"};
  return without_ending(file, endings);
}

/// What an operating system leaves in folders and archives: no student has made it.
inline bool is_clutter(const std::string& name) {
  static constexpr std::array<std::string_view, 4> names = {"__macosx", ".ds_store", "thumbs.db",
                                                            "desktop.ini"};
  return name.starts_with("._") ||
         std::find(names.begin(), names.end(), lower_case(name)) != names.end();
}

}  // namespace tumble::judge
