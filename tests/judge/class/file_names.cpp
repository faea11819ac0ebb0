#include "judge/class/file_names.hpp"

#include <algorithm>
#include <cstdio>
#include <regex>
#include <vector>

#include "judge/class/file_kinds.hpp"
#include "judge/course/stable_hash.hpp"
#include "judge/verdict/number_text.hpp"
#include "support/printable.hpp"

namespace tumble::judge {

namespace fs = std::filesystem;

namespace {

bool is_decimal(char c) { return c >= '0' && c <= '9'; }

/// The digits from `at` on, without leading zeros.
std::string digits_at(const std::string& text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_decimal(text[end])) ++end;
  while (at + 1 < end && text[at] == '0') ++at;
  return text.substr(at, end - at);
}

std::size_t end_of_digits(const std::string& text, std::size_t at) {
  while (at < text.size() && is_decimal(text[at])) ++at;
  return at;
}

/// −1, 0 or 1, numbers by their value.
int natural_order(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_decimal(a[i]) && is_decimal(b[j])) {
      const std::string m = digits_at(a, i), n = digits_at(b, j);
      if (m.size() != n.size()) return m.size() < n.size() ? -1 : 1;
      if (m != n) return m < n ? -1 : 1;
      i = end_of_digits(a, i);
      j = end_of_digits(b, j);
    } else {
      const auto x = static_cast<unsigned char>(a[i++]), y = static_cast<unsigned char>(b[j++]);
      if (x != y) return x < y ? -1 : 1;
    }
  }
  return i < a.size() ? 1 : j < b.size() ? -1 : 0;
}

/// What is before the ending of a source file or an archive; other names are as they are.
std::string without_known_ending(const std::string& name) {
  for (const std::string& stem : {source_stem(name), archive_stem(name)})
    if (!stem.empty()) return stem;
  return name;
}

/// The parts of a path, without their endings: in hw.zip/a.cpp an archive stands for a folder.
std::vector<std::string> path_parts(const fs::path& path) {
  std::vector<std::string> parts;
  for (const fs::path& part : path) parts.push_back(without_known_ending(part.string()));
  return parts;
}

/// At most this many bytes, and no half of a character.
std::string cut(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
  return text.substr(0, most);
}

}  // namespace

std::string exercise_named(const std::string& file) {
  std::string name = lower_case(source_stem(file));
  // What browsers, platforms and file managers add to the second file of a name.
  static const std::regex after(
      R"((.*[^ _-])(?:[ _]?\((?:copy|kopie|copy \d+|\d+|\d+\. kopie)\)|-\d+|)"
      R"([ _]?-[ _]?(?:copy|kopie|copie|copia)|[ _](?:copy|kopie)| \d+))");
  static const std::regex before("(?:copy of|kopie von)[ _](.+)");
  for (std::smatch match;
       std::regex_match(name, match, after) || std::regex_match(name, match, before);)
    name = std::string(match[1]);
  return name;
}

bool natural_less(const std::string& a, const std::string& b) {
  const int order = natural_order(lower_case(a), lower_case(b));
  return order != 0 ? order < 0 : a < b;
}

bool natural_less(const fs::path& a, const fs::path& b) {
  const std::vector<std::string> x = path_parts(a), y = path_parts(b);
  if (x == y) return a.string() > b.string();  // product.cpp.txt before product.cpp
  return std::lexicographical_compare(
      x.begin(), x.end(), y.begin(), y.end(),
      [](const std::string& p, const std::string& q) { return natural_less(p, q); });
}

std::string file_name_for(const std::string& student) {
  constexpr std::size_t most = 180;  // and an ending: file systems take 255 bytes
  std::string name = cut(student, most);
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '/'; }, '_');
  if (name.starts_with(".")) name[0] = '_';
  if (name == student) return name;
  char number[24];
  std::snprintf(number, sizeof number, "-%016llx",
                static_cast<unsigned long long>(stable_hash(student)));
  return name + number;
}

std::string escaped(const std::string& name) { return one_line(support::escaped(name), 300); }

}  // namespace tumble::judge
