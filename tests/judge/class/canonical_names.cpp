#include "judge/class/canonical_names.hpp"

#include <algorithm>

namespace tumble::judge {

bool is_ascii(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) { return (c & 0x80) == 0; });
}

std::string spelling_doubt(const std::string& name) {
  if (is_ascii(name) || compares_canonically()) return "";
  return ": names with accents are compared byte by byte, as tumble was built without utf8proc";
}

}  // namespace tumble::judge
