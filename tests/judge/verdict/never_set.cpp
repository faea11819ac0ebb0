#include "judge/verdict/never_set.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <sstream>

#include "judge/build/source_code.hpp"

namespace tumble::judge {

namespace {

/// What gcc and clang say of such a variable.
bool is_about_it(const std::string& line) {
  constexpr std::array words = {"is used uninitialized", "may be used uninitialized",
                                "is uninitialized when", "may be uninitialized when"};
  return line.find("warning: ") != std::string::npos &&
         std::any_of(words.begin(), words.end(),
                     [&](const char* each) { return line.find(each) != std::string::npos; });
}

/// The name in a line's first quotes: "body.mass" of 'body.only_what::Body::mass'. Empty if it is
/// none that is in a student's file: a part of Eigen, or <anonymous>.
std::string variable_in(const std::string& line) {
  const std::size_t begin = line.find('\''), end = line.find('\'', begin + 1);
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::string name;
  std::istringstream parts(line.substr(begin + 1, end - begin - 1));
  for (std::string part; std::getline(parts, part, '.');) {
    if (part.find("Eigen") != std::string::npos) break;  // how a matrix keeps its numbers
    if (const auto at = part.rfind("::"); at != std::string::npos) part.erase(0, at + 2);
    name += (name.empty() ? "" : ".") + part;
  }
  const bool is_name = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '.';
  });
  return is_name ? name : "";
}

/// "energy_drift.cpp:18" of a message that begins with "energy_drift.cpp:18:10: "; else empty.
std::string place_in(const std::string& line, const std::string& file) {
  if (!line.starts_with(file + ":")) return {};
  const std::size_t end = line.find(':', file.size() + 1);
  return end == std::string::npos ? "" : line.substr(0, end);
}

}  // namespace

std::optional<NeverSet> never_set_in(const std::string& warnings, const std::string& file) {
  std::istringstream in(warnings);
  std::string variable;
  for (std::string line; std::getline(in, line);) {
    if (is_about_it(line)) variable = variable_in(line);
    // A warning at a place in another file has a note, where the variable is declared.
    const bool is_note = line.find("note: '") != std::string::npos && variable == variable_in(line);
    if (variable.empty() || !(is_about_it(line) || is_note)) continue;
    if (const std::string place = place_in(line, file); !place.empty())
      return NeverSet{variable, place};
  }
  return std::nullopt;
}

bool declares_without_value(const std::string& source) {
  static const std::regex declaration(
      R"((?:^|[;{}])\s*(?:std::)?(?:double|bool|int|float|long|size_t) +[A-Za-z_]\w{0,40} *[;,])");
  std::istringstream in(code_of(source));
  for (std::string line; std::getline(in, line);)
    if (line.size() < 400 && std::regex_search(line, declaration)) return true;
  return false;
}

void name_variable(Finding& finding, const NeverSet& variable) {
  if (finding.outcome != Outcome::wrong || !finding.answer) return;
  const std::string sentence = "The compiler sees that “" + variable.variable + "” (" +
                               variable.place + ") may be used before it is set.";
  if (finding.misconceptions.empty())
    finding.misconceptions = {{"never set", sentence, ""}};
  else if (Misconception& first = finding.misconceptions.front();
           first.name == "never set" || first.name == "not a number")
    first.sentence += " " + sentence;
}

}  // namespace tumble::judge
