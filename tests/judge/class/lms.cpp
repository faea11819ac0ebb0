#include "judge/class/lms.hpp"

#include <regex>

#include "tumble/core/require.hpp"

namespace tumble::judge {

Lms lms_named(const std::string& name) {
  for (const Lms lms : {Lms::moodle, Lms::canvas, Lms::gradescope, Lms::none})
    if (name == name_of(lms)) return lms;
  tumble::detail::refuse("there is no platform '", name,
                         "' to download from; there are: ", lms_names);
}

std::string name_of(Lms lms) {
  switch (lms) {
    case Lms::moodle:
      return "moodle";
    case Lms::canvas:
      return "canvas";
    case Lms::gradescope:
      return "gradescope";
    case Lms::none:
      break;
  }
  return "folders";
}

std::optional<LmsEntry> moodle_entry(const std::string& name) {
  static const std::regex pattern(R"(([^/]+)_(\d+)_assignsubmission_([a-z0-9]+)(?:_([^/]*))?)");
  std::smatch match;
  if (!std::regex_match(name, match, pattern)) return std::nullopt;
  LmsEntry entry{match[1], match[2], match[4], "", false, match[3] != "file"};
  if (entry.is_text && match[3] != "onlinetext") entry.kind = match[3];
  return entry;
}

std::optional<LmsEntry> canvas_entry(const std::string& name) {
  static const std::regex upload(R"(([^_]+)(_LATE)?_(\d+)_(\d+)_([^/]+))"),
      anonymous(R"((anon)(_LATE)?_([A-Za-z0-9]+)_(\d+)_([^/]+))"),
      typed(R"(([^_]+)(_LATE)?_(\d+)_((?:text|link)\.html))");
  std::smatch match;
  for (const std::regex* pattern : {&anonymous, &upload})
    if (std::regex_match(name, match, *pattern))
      return LmsEntry{match[1], match[3], match[5], match[4], match[2].matched, false};
  if (std::regex_match(name, match, typed))
    return LmsEntry{match[1], match[3], match[4], "", match[2].matched, true};
  return std::nullopt;
}

}  // namespace tumble::judge
