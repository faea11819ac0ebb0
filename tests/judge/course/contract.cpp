#include "judge/course/contract.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "support/trimmed.hpp"

namespace tumble::judge {

namespace {

/// Reads "(const Quaternion& a, double t)": a name is the last word before a comma of the list.
void read_parameters(const std::string& signature, Declaration& declaration) {
  std::string parameter;
  int depth = 0;
  const auto finish = [&] {
    parameter = support::trimmed(parameter);
    const auto last = parameter.find_last_of(" &*");
    if (!parameter.empty()) {
      declaration.parameters.push_back(parameter.substr(last + 1));
      declaration.types.push_back(parameter.substr(0, last + 1));
    }
    parameter.clear();
  };
  for (std::size_t i = signature.find('('); i + 1 < signature.size(); ++i) {
    const char c = signature[i];
    if (c == ')' && depth == 1) break;
    if (c == ',' && depth == 1)
      finish();
    else if (c != '(' || depth > 0)
      parameter += c;
    if (c == '(' || c == '<') ++depth;
    if (c == ')' || c == '>') --depth;
  }
  finish();
}

std::string where_help_is(const Unit& unit, Help help) {
  if (help == Help::buttons)
    return "The contract above says what to write. Stuck? Hint, below. Done? Check.";
  return "contract.hpp says what to write. Stuck? ./tumble hint " + unit.number +
         " · Done? ./tumble check " + unit.number;
}

}  // namespace

Declaration read_declaration(const Course& course, const Unit& unit) {
  const fs::path file = course.contract(unit);
  const std::string heading = "// == " + unit.number + " " + unit.name + ": ";
  std::ifstream in(file);
  Declaration declaration;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(heading)) {
      declaration.title = line.substr(heading.size());
    } else if (!declaration.title.empty() && !line.starts_with("//")) {
      const auto end = line.find(';');
      declaration.signature += line.substr(0, end) + "\n";
      if (end == std::string::npos) continue;
      declaration.signature = support::trimmed(declaration.signature);
      read_parameters(declaration.signature, declaration);
      declaration.result =
          declaration.signature.substr(0, declaration.signature.find(" " + unit.name));
      return declaration;
    }
  }
  throw std::runtime_error(file.string() + " does not declare " + unit.number + " " + unit.name);
}

std::string stub_of(const Course& course, const Unit& unit, Help help) {
  const Declaration declaration = read_declaration(course, unit);
  const std::string space = unit.chapter.substr(unit.chapter.find('_') + 1);
  std::ostringstream stub;
  stub << "#include \"contract.hpp\"\n\nnamespace " << space << " {\n\n// " << unit.number << " "
       << unit.name << ": " << declaration.title << (declaration.title.ends_with("?") ? "" : ".")
       << "\n// " << where_help_is(unit, help) << "\n"
       << declaration.signature << " {\n  throw NotImplemented{};\n}\n\n}  // namespace " << space
       << "\n";
  return stub.str();
}

}  // namespace tumble::judge
