#include "judge/build/link_failure.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "judge/build/diagnostics.hpp"
#include "judge/build/source_code.hpp"
#include "judge/course/contract.hpp"

namespace tumble::judge {

namespace {

/// "std::function<Eigen::VectorXd (double, const Eigen::VectorXd&)>", as compilers tell it, of a
/// contract's "std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& y)>".
std::string without_parameter_names(const std::string& type) {
  static const std::regex name(R"(([&\s])\w+(?=\s*[,)]))"), list(R"(\()"), blanks(R"(\s+(?=[,)]))");
  return std::regex_replace(std::regex_replace(std::regex_replace(type, name, "$1"), list, " ("),
                            blanks, "");
}

/// A function's types as the contract writes them: "Rhs" for what it gives that name.
class ContractNames {
 public:
  explicit ContractNames(const fs::path& contract) {
    static const std::regex alias(R"(^using (\w+) = (std::function<.*>);)");
    std::ifstream in(contract);
    std::smatch parts;
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line, parts, alias))
        names_.emplace_back(without_parameter_names(parts[2].str()), parts[1].str());
  }

  std::string in(const std::string& function) const {
    static const std::regex reference(R"(([\w:]+) const&)");
    std::string text =
        std::regex_replace(with_short_types(function.substr(0, 2000)), reference, "const $1&");
    for (const auto& [type, name] : names_) {
      for (auto at = text.find(type); at != std::string::npos; at = text.find(type, at))
        text.replace(at, type.size(), name);
      for (auto at = text.find(name + " const&"); at != std::string::npos;
           at = text.find(name + " const&"))
        text.replace(at, name.size() + 7, "const " + name + "&");
    }
    return text.substr(0, 200);
  }

 private:
  std::vector<std::pair<std::string, std::string>> names_;
};

std::string found_instead(const std::vector<std::string>& functions, const ContractNames& names) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, functions.size()); ++i)
    text += "  " + names.in(functions[i]) + "\n";
  return text.empty() ? "" : "found there:\n" + text;
}

/// What opens a block and is before it: "namespace particles", "inline VectorXd f(double x)".
std::string opening(const std::string& code, std::size_t brace) {
  const auto before = brace == 0 ? std::string::npos : code.find_last_of(";{}", brace - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  std::istringstream in(code.substr(begin, brace - begin));
  std::string text;
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t") == std::string::npos ||
        line[line.find_first_not_of(" \t")] != '#')
      text += line + " ";
  return text;
}

/// Why other files can't see a function that is opened so; empty if they can.
std::string reason_in(const std::string& opening) {
  if (has_word(opening, "template")) return "a template";
  if (has_word(opening, "static")) return "static";
  if (has_word(opening, "inline") || has_word(opening, "constexpr")) return "inline";
  return {};
}

/// Why other files can't see the function of this name, which the code defines; empty if they can,
/// or if it doesn't define it.
std::string why_hidden(const std::string& code, const std::string& name) {
  static const std::regex unnamed(R"(\bnamespace\s*$)");
  std::vector<bool> is_hidden;  // of each block that is open: is its namespace unnamed?
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code[i] == '}' && !is_hidden.empty()) is_hidden.pop_back();
    if (code[i] != '{') continue;
    const std::string here = opening(code, i);
    const bool is_function = has_word(here.substr(0, here.find('(')), name) &&
                             here.find('(') != std::string::npos && here.find('=') > here.find('(');
    if (is_function && std::find(is_hidden.begin(), is_hidden.end(), true) != is_hidden.end())
      return "in a namespace without a name";
    if (std::string reason = is_function ? reason_in(here) : ""; !reason.empty()) return reason;
    is_hidden.push_back(here.size() < 400 && std::regex_search(here, unnamed));
  }
  return {};
}

/// Whether the code has nothing but directives: #include "contract.hpp".
bool defines_nothing(const std::string& code) {
  std::istringstream in(code);
  for (std::string line; std::getline(in, line);) {
    const auto start = line.find_first_not_of(" \t\r");
    if (start != std::string::npos && line[start] != '#') return false;
  }
  return true;
}

/// The scope of the function of this name among these: "particles::", "" of "f(double)"; nothing if
/// none has it. Of several, the one that is wanted.
std::optional<std::string> scope_of(const std::string& name,
                                    const std::vector<std::string>& functions,
                                    const std::string& wanted) {
  std::optional<std::string> scope;
  for (const std::string& function : functions) {
    const std::string whole = function.substr(0, function.find('('));
    if (whole != name && !whole.ends_with("::" + name)) continue;
    const std::string own = whole.substr(0, whole.size() - name.size());
    if (!scope || own == wanted) scope = own;
  }
  return scope;
}

/// What to do so that the function of the contract is found.
std::string advice_for(const Course& course, const Unit& unit, const std::string& code,
                       const std::vector<std::string>& functions) {
  if (defines_nothing(code))
    return "Your file defines nothing: it has comments and directives alone.\n";
  const std::string whole = unit.function(),
                    space = whole.substr(0, whole.size() - unit.name.size() - 2);
  const std::optional<std::string> scope = scope_of(unit.name, functions, space + "::");
  if (scope && *scope != space + "::") return "Put it into namespace " + space + ".\n";
  if (const std::string why = why_hidden(code, unit.name); !scope && !why.empty())
    return "Your " + unit.name + " is " + why +
           ".\nOther files can't see it, and the judge is one of them.\nDefine it as a plain "
           "function in namespace " +
           space + ".\n";
  return "Its name, the types of its arguments (with const and &) and the namespace have to be\n"
         "those of " +
         fs::relative(course.contract(unit), course.root).string() + ".\n";
}

std::string text_about(const std::vector<std::string>& undefined) {
  std::string text = "Your code calls these functions, but nothing defines them:\n";
  for (const std::string& name : undefined) text += "  " + brief_name(name) + "\n";
  const bool of_eigen = undefined.front().find("Eigen::") != std::string::npos;
  return text +
         (of_eigen
              ? "(An exercise has Eigen/Core alone. cross(), inverse() and determinant() are in\n"
                "other headers of Eigen: write out what you need of them. For a × b you have 3.2:\n"
                "skew(a) * b in chapter 3, rotation_matrices::skew(a) * b from chapter 5 on.\n"
                "Chapter 4 has no skew: there you write the three components out.)\n"
              : "(A later exercise? A helper that is declared, but not defined?)\n");
}

}  // namespace

void explain_link_failure(BuildReport& report, const Course& course, const Unit& unit,
                          const std::string& linker_output,
                          const std::vector<std::string>& functions, const std::string& source) {
  const std::vector<std::string> undefined = undefined_functions(linker_output);
  const bool absent = std::any_of(undefined.begin(), undefined.end(), [&](const auto& name) {
    return name.ends_with("::" + unit.name);
  });
  report.explained = !undefined.empty();
  report.involves_course = true;
  if (absent) {
    report.outcome = BuildOutcome::wrong_signature;
    report.detail = read_declaration(course, unit).signature + "\n" +
                    found_instead(functions, ContractNames(course.contract(unit))) + "\n" +
                    advice_for(course, unit, code_of(source), functions);
  } else if (!undefined.empty()) {
    report.detail = text_about(undefined);
  } else {  // names of functions, no text of a file
    report.detail = "linking fails:\n" + linker_output;
  }
}

}  // namespace tumble::judge
