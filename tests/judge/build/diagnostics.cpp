#include "judge/build/diagnostics.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <string_view>

namespace tumble::judge {

namespace {

constexpr int most_shown = 30;

/// Does a message start here? "path:line:column: error: …"
bool starts_message(std::string_view line) {
  constexpr std::array kinds = {": error: ", ": warning: ", ": note: ", ": fatal error: "};
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const char* kind) { return line.find(kind) != std::string_view::npos; });
}

bool is_error(std::string_view line) { return line.find("error: ") != std::string_view::npos; }

std::string without(std::string text, const std::string& part) {
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at))
    text.erase(at, part.size());
  return text;
}

/// "Vector3d" for 3 rows and 1 column; empty if it has no such name. −1 is any number.
std::string name_of_matrix(int rows, int columns) {
  const int size = rows == 1 ? columns : rows;
  const bool has_name = size == -1 || (size >= 2 && size <= 4);
  if (!has_name || (rows != 1 && columns != 1 && rows != columns)) return {};
  const std::string kind = rows == 1 ? "RowVector" : columns == 1 ? "Vector" : "Matrix";
  return "Eigen::" + kind + (size == -1 ? "X" : std::to_string(size)) + "d";
}

}  // namespace

std::string with_short_types(const std::string& line) {
  constexpr std::size_t most_read = 2000;  // a regular expression takes stack for each character
  static const std::regex quoted_source(R"(^ *\d+ \|)"), also_known_as(R"( \{aka [^{}]*\})"),
      matrix(
          R"(Eigen::Matrix<double, (-?\d{1,4}), (-?\d{1,4})(, \d{1,4}(, -?\d{1,4}, -?\d{1,4})?)?>)"),
      entry(R"(Eigen::DenseCoeffsBase<[^<>]*>::Scalar)");
  if (line.size() > most_read || std::regex_search(line, quoted_source)) return line;
  std::string text;
  auto from = line.cbegin();
  for (std::sregex_iterator it(line.begin(), line.end(), matrix), end; it != end; ++it) {
    const std::string name = name_of_matrix(std::stoi((*it)[1]), std::stoi((*it)[2]));
    text.append(from, (*it)[0].first).append(name.empty() ? it->str() : name);
    from = (*it)[0].second;
  }
  text.append(from, line.cend());
  return std::regex_replace(std::regex_replace(text, also_known_as, ""), entry, "double");
}

std::string messages_about(const std::filesystem::path& source, const std::string& compiler_output,
                           bool others) {
  const std::string folder = source.parent_path().string() + "/";
  const std::string own = source.filename().string() + ":";
  std::istringstream in(compiler_output);
  std::string kept, elsewhere;  // the last warning at a place elsewhere: its notes may be about us
  bool keep = false;
  int lines = 0;
  for (std::string line; std::getline(in, line) && lines < most_shown;) {
    const bool about_source = line.starts_with(folder + own);
    if (starts_message(line)) {
      // gcc indents why each overload of Eigen's does not fit: pages, and nothing of the student's.
      const bool why_not_this_one = line.find(": note:   ") != std::string::npos;
      // "suggested alternatives:" has them in such notes, at places elsewhere.
      if (const auto at = line.find(": note:   '");
          at != std::string::npos && !about_source && kept.ends_with("alternatives:\n"))
        kept.insert(kept.size() - 1, " " + line.substr(at + 10));
      keep = about_source && !why_not_this_one;
      const bool is_note = line.find(": note: ") != std::string::npos;
      if (keep && is_note && !elsewhere.empty()) {
        kept += elsewhere + "\n";
        ++lines;
      }
      if (keep || !is_note) elsewhere.clear();
      if (const auto at = line.find("warning: "); !keep && at != std::string::npos)
        elsewhere = line.substr(at);
    } else if (!line.starts_with(' ')) {
      keep = false;  // "In file included from", "required from", totals: not for a beginner
    }
    if (!keep && others && is_error(line) && starts_message(line)) {
      kept += line.substr(line.find("error: ")) + "\n";
      ++lines;
    }
    const bool in_function = about_source && !starts_message(line);  // "a.cpp: In function 'f':"
    if (!keep && !in_function) continue;
    kept += with_short_types(without(line, folder)) + "\n";
    ++lines;
  }
  return kept;
}

bool has_error_in(const std::filesystem::path& source, const std::string& compiler_output) {
  constexpr std::array of_the_machine = {
      "No space left",   "error writing",      "Cannot allocate", "out of memory",
      "exhausted",       "Input/output",       "cannot execute",  "internal compiler error",
      "File size limit", "Too many open files"};
  std::istringstream in(compiler_output);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(source.string() + ":") || !starts_message(line) || !is_error(line))
      continue;
    if (std::none_of(of_the_machine.begin(), of_the_machine.end(),
                     [&](const char* words) { return line.find(words) != std::string::npos; }))
      return true;
  }
  return false;
}

std::string advice_on(const std::string& compiler_output) {
  // What both compilers say of Eigen::Quaterniond. Eigen/Core declares Quaternion, which leads on.
  static const std::regex not_of_eigen(
      "'(\\w{1,40})' is not a member of 'Eigen'|no member named '(\\w{1,40})' in namespace "
      "'Eigen'");
  static const std::regex contract_elsewhere(
      "fatal error: '?[^ ':]{1,200}/contract\\.hpp('|: No such)");
  std::string advice;
  if (std::regex_search(compiler_output, contract_elsewhere))
    advice += "(Write #include \"contract.hpp\", without a folder.)\n";
  if (compiler_output.find("<unresolved overloaded function type>") != std::string::npos)
    advice += "(Parentheses forgotten? With Eigen v.x and q.w are functions: v.x(), q.w().)\n";
  if (std::smatch parts; std::regex_search(compiler_output, parts, not_of_eigen))
    advice += "(An exercise has Eigen/Core alone, and " + parts[1].str() + parts[2].str() +
              " is not in there: write out what you need of it.)\n";
  return advice;
}

namespace {

/// Whether a line is a driver's own: "c++: fatal error: …", and not one about a file or a quotation
/// of it.
bool is_drivers(std::string_view line) {
  const std::size_t name = line.find(": ");
  return name != 0 && name != std::string_view::npos &&
         line.substr(0, name).find_first_of(" /\\|:\"'<>{}()") == std::string_view::npos;
}

/// Whether a driver says here that one of its programs was killed.
bool tells_a_kill(std::string_view line) {
  constexpr std::array words = {"fatal error: Killed signal terminated program",
                                "internal compiler error: Killed",
                                "fatal error: ld terminated with signal 9 [Killed]",
                                "error: unable to execute command: Killed"};
  if (!is_drivers(line)) return false;
  line.remove_prefix(line.find(": ") + 2);
  return std::any_of(words.begin(), words.end(),
                     [&](const char* start) { return line.starts_with(start); });
}

}  // namespace

bool says_that_it_was_killed(const std::string& compiler_output) {
  std::istringstream in(compiler_output);
  bool killed = false;
  for (std::string line; std::getline(in, line);) {
    // What still comes is the compiler's, which lives, or a quotation of a file.
    if (line.starts_with(' ') || (starts_message(line) && !is_drivers(line))) killed = false;
    if (tells_a_kill(line)) killed = true;
  }
  return killed;
}

namespace {

/// The names that follow one of these texts, each once.
std::vector<std::string> names_after(const std::vector<std::string>& texts,
                                     const std::string& linker_output) {
  std::istringstream in(linker_output);
  std::vector<std::string> names;
  for (std::string line; std::getline(in, line);)
    for (const std::string& before : texts) {
      const auto at = line.find(before);
      if (at == std::string::npos) continue;
      const auto start = at + before.size();
      const std::string name = line.substr(start, line.find_first_of("('", start) - start);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  return names;
}

}  // namespace

std::vector<std::string> undefined_functions(const std::string& linker_output) {
  return names_after({"undefined symbol: ", "undefined reference to `", "undefined reference to '"},
                     linker_output);
}

std::string brief_name(const std::string& function) {
  if (function.find("Eigen::") == std::string::npos) return function;
  std::string name = function;
  if (name.ends_with('>')) {  // its own types: back to where they open
    std::size_t at = name.size();
    int open = 0;
    do {
      --at;
      open += name[at] == '>' ? 1 : name[at] == '<' ? -1 : 0;
    } while (open > 0 && at > 0);
    if (open > 0) return function;
    name.erase(at);
  }
  const std::size_t scope = name.rfind("::");
  return scope == std::string::npos ? name : name.substr(scope + 2);
}

std::vector<std::string> duplicate_functions(const std::string& linker_output) {
  std::vector<std::string> names =
      names_after({"multiple definition of `", "multiple definition of '", "duplicate symbol: "},
                  linker_output);
  for (std::string& name : names)  // mold names the files first
    if (const auto at = name.rfind(": "); at != std::string::npos) name.erase(0, at + 2);
  return names;
}

}  // namespace tumble::judge
