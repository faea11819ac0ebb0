#include <utf8proc.h>

#include <cstdlib>
#include <memory>

#include "judge/class/canonical_names.hpp"
#include "judge/class/file_kinds.hpp"

namespace tumble::judge {

namespace {

struct Free {
  void operator()(utf8proc_uint8_t* text) const { std::free(text); }
};

const utf8proc_uint8_t* utf8_of(const std::string& text) {
  return reinterpret_cast<const utf8proc_uint8_t*>(text.data());
}

/// The name after these changes; as it is if it is not UTF-8.
std::string changed(const std::string& name, int options) {
  if (is_ascii(name)) return name;  // as most are: a class of thousands compares them often
  utf8proc_uint8_t* to = nullptr;
  const utf8proc_ssize_t size =
      utf8proc_map(utf8_of(name), static_cast<utf8proc_ssize_t>(name.size()), &to,
                   static_cast<utf8proc_option_t>(UTF8PROC_STABLE | options));
  const std::unique_ptr<utf8proc_uint8_t, Free> owner(to);
  return size < 0 ? name : std::string(to, to + size);
}

/// Does a character tell two people apart? Punctuation, spaces and what cannot be seen do not:
/// O'Brien is spelt with two apostrophes.
bool tells_apart(utf8proc_int32_t character) {
  if (character < 0x80)
    return (character >= 'a' && character <= 'z') || (character >= '0' && character <= '9');
  const utf8proc_category_t kind = utf8proc_category(character);
  const bool punctuation = kind >= UTF8PROC_CATEGORY_PC && kind <= UTF8PROC_CATEGORY_PO;
  return !punctuation && (kind < UTF8PROC_CATEGORY_ZS || kind > UTF8PROC_CATEGORY_CF);
}

}  // namespace

std::string canonical(const std::string& name) { return changed(name, UTF8PROC_COMPOSE); }

std::string folded(const std::string& name) {
  return lower_case(changed(name, UTF8PROC_COMPOSE | UTF8PROC_CASEFOLD));
}

std::string letters_of(const std::string& name) {
  const std::string all = folded(name);
  std::string text;
  for (std::size_t at = 0; at < all.size();) {
    utf8proc_int32_t character = 0;
    const utf8proc_ssize_t read = utf8proc_iterate(
        utf8_of(all) + at, static_cast<utf8proc_ssize_t>(all.size() - at), &character);
    const std::size_t size = read > 0 ? static_cast<std::size_t>(read) : 1;  // not UTF-8: a byte
    if (read <= 0 || tells_apart(character)) text.append(all, at, size);
    at += size;
  }
  return text;
}

bool compares_canonically() { return true; }

}  // namespace tumble::judge
