#include "project/bench/judge/mistakes.hpp"

#include <array>
#include <sstream>
#include <utility>
#include <vector>

namespace tumble::bench {

namespace {

using Replacement = std::pair<const char*, const char*>;

constexpr std::array<Replacement, 16> confusions = {{{" + ", " - "},
                                                     {" - ", " + "},
                                                     {" += ", " -= "},
                                                     {" * ", " + "},
                                                     {" / ", " * "},
                                                     {"0.5 * ", ""},
                                                     {" / 2", ""},
                                                     {"2 * ", ""},
                                                     {".transpose()", ""},
                                                     {"sin(", "cos("},
                                                     {"cos(", "sin("},
                                                     {" < ", " > "},
                                                     {"[1]", "[2]"},
                                                     {"[0]", "[1]"},
                                                     {".normalized()", ""},
                                                     {"std::sqrt", ""}}};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// A line of a function, not a comment, an #include or a namespace.
bool computes(const std::string& line) {
  const auto start = line.find_first_not_of(' ');
  return start != std::string::npos && start >= 2 && line.compare(start, 2, "//") != 0;
}

/// A place where a confusion can happen.
struct Chance {
  std::size_t line, column;
  const Replacement* confusion;  ///< none: the line is missing
};

/// A line that can go without the rest becoming no program: it changes what is there already.
bool can_be_forgotten(const std::string& line) {
  for (const char* change : {" += ", " -= ", " *= ", " /= ", ") = ", "] = "})
    if (line.find(change) != std::string::npos && line.ends_with(';')) return true;
  return false;
}

std::vector<Chance> chances_in(const std::vector<std::string>& lines) {
  std::vector<Chance> chances;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!computes(lines[i])) continue;
    if (can_be_forgotten(lines[i])) chances.push_back({i, 0, nullptr});
    for (const Replacement& each : confusions)
      for (auto at = lines[i].find(each.first); at != std::string::npos;
           at = lines[i].find(each.first, at + 1))
        chances.push_back({i, at, &each});
  }
  return chances;
}

}  // namespace

std::size_t pick(test::Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.uniform(0, static_cast<double>(count)));
}

std::string with_mistake(const std::string& source, test::Random& random) {
  std::vector<std::string> lines = lines_of(source);
  const std::vector<Chance> chances = chances_in(lines);
  if (chances.empty()) return source;
  const Chance& chance = chances[pick(random, chances.size())];
  std::string& line = lines[chance.line];
  if (chance.confusion)
    line.replace(chance.column, std::string(chance.confusion->first).size(),
                 chance.confusion->second);
  else
    line.clear();
  return joined(lines);
}

std::string that_does_not_compile(const std::string& source, test::Random& random) {
  const char needed = "{};"[pick(random, 3)];
  std::vector<std::size_t> places;
  const auto start = source.find("namespace");
  for (auto at = source.find(needed, start); at != std::string::npos;
       at = source.find(needed, at + 1))
    places.push_back(at);
  std::string text = source;
  return places.empty() ? text + "}" : text.erase(places[pick(random, places.size())], 1);
}

}  // namespace tumble::bench
