#include "judge/platforms/image_name.hpp"

#include <algorithm>
#include <cctype>
#include <regex>

#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

bool is_image_name(const std::string& name) {
  static const std::regex registry(R"([A-Za-z0-9-]+(\.[A-Za-z0-9-]+)*(:\d+)?)");
  static const std::regex path(
      R"([a-z0-9]+((\.|__?|-+)[a-z0-9]+)*(/[a-z0-9]+((\.|__?|-+)[a-z0-9]+)*)*)"
      R"((:\w[\w.-]{0,127})?(@sha256:[0-9a-f]{64})?)");
  const std::size_t slash = name.find('/');
  const std::string first = name.substr(0, slash);
  // A first part is an address only if it looks like one.
  const bool has_registry =
      slash != std::string::npos &&
      (first == "localhost" || first.find_first_of(".:") != std::string::npos);
  if (!has_registry) return std::regex_match(name, path);
  return std::regex_match(first, registry) && std::regex_match(name.substr(slash + 1), path);
}

std::string in_lower_case(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

}  // namespace

void require_image_name(const std::string& name) {
  if (name.size() < 256 && is_image_name(name)) return;
  const std::string lower = in_lower_case(name);
  const bool is_near = lower.size() < 256 && is_image_name(lower);
  require(
      false, "'", name.substr(0, 256),
      "' is not the name of an image: it has lower case letters, digits, and - . _ between them, "
      "such as owner/tumble-judge",
      is_near ? "; did you mean " + lower + "?" : "");
}

}  // namespace tumble::judge
