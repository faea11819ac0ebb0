#include "judge/class/canonical_names.hpp"
#include "judge/class/file_kinds.hpp"

namespace tumble::judge {

std::string canonical(const std::string& name) { return name; }

std::string folded(const std::string& name) { return lower_case(name); }

std::string letters_of(const std::string& name) {
  std::string text;
  for (const char c : lower_case(name))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80)) text += c;
  return text;
}

bool compares_canonically() { return false; }

}  // namespace tumble::judge
