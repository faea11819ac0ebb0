#include "judge/platforms/slug.hpp"

#include <cctype>

namespace tumble::judge {

std::string slug_of(const std::string& title) {
  std::string slug;
  for (const char c : title) {
    const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if ((lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9'))
      slug += lower;
    else if (!slug.empty() && slug.back() != '-')
      slug += '-';
  }
  slug = slug.substr(0, 39);
  while (!slug.empty() && slug.back() == '-') slug.pop_back();
  return slug.size() < 2 ? "tumble" : slug;
}

}  // namespace tumble::judge
