#include "judge/course/contract_types.hpp"

#include <fstream>
#include <regex>
#include <sstream>

namespace tumble::judge {

namespace {

std::string without_comment(const std::string& line) { return line.substr(0, line.find("//")); }

/// "Body" of "const rigid_body::Body&".
std::string bare(const std::string& type) {
  static const std::regex around(R"(\bconst\b|[&\s]|^.*::(?![^<]*>))");
  return std::regex_replace(type, around, "");
}

/// "double aa, ab, bb;" as members of one type.
void add_members(const std::string& line, std::vector<ContractMember>& members) {
  static const std::regex declaration(R"(^\s+(\S.*?)\s+(\w+(?:\s*,\s*\w+)*)\s*;\s*$)");
  std::smatch parts;
  const std::string code = without_comment(line);
  if (!std::regex_match(code, parts, declaration)) return;
  std::istringstream names(parts[2].str());
  for (std::string name; std::getline(names, name, ',');)
    members.push_back({parts[1].str(), std::regex_replace(name, std::regex(R"(\s)"), "")});
}

void add_enumerators(const std::string& line, std::vector<std::string>& enumerators) {
  static const std::regex name(R"((\w+)(?:\s*=\s*\d+)?\s*(?:,|$))");
  const std::string code = without_comment(line);
  for (std::sregex_iterator it(code.begin(), code.end(), name), end; it != end; ++it)
    enumerators.push_back((*it)[1].str());
}

template <class T>
const T& find_or_empty(const std::map<std::string, T>& all, const std::string& type) {
  static const T empty;
  const auto found = all.find(bare(type));
  return found == all.end() ? empty : found->second;
}

}  // namespace

ContractTypes::ContractTypes(const Course& course, const Unit& unit) {
  read(course.contract(unit));
}

void ContractTypes::read(const fs::path& contract) {
  static const std::regex include(R"re(^#include "(\.\./\w+/contract\.hpp)")re");
  static const std::regex structure(R"(^struct (\w+) \{)"), enumeration(R"(^enum class (\w+) \{)");
  std::ifstream in(contract);
  std::vector<ContractMember>* members = nullptr;
  std::vector<std::string>* enumerators = nullptr;
  std::smatch parts;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_search(line, parts, include)) {
      read(contract.parent_path() / parts[1].str());
    } else if (std::regex_search(line, parts, structure)) {
      members = &structs_[parts[1].str()];
    } else if (std::regex_search(line, parts, enumeration)) {
      enumerators = &enumerations_[parts[1].str()];
    } else if (line.starts_with("};")) {
      members = nullptr;
      enumerators = nullptr;
    } else if (members) {
      add_members(line, *members);
    } else if (enumerators) {
      add_enumerators(line, *enumerators);
    }
  }
}

const std::vector<ContractMember>& ContractTypes::members_of(const std::string& type) const {
  return find_or_empty(structs_, type);
}

const std::vector<std::string>& ContractTypes::enumerators_of(const std::string& type) const {
  return find_or_empty(enumerations_, type);
}

std::string ContractTypes::element_of(const std::string& type) {
  static const std::regex list(R"(std::(?:vector|array)<\s*([^,]*?)\s*(?:,[^>]*)?>\s*&?\s*$)");
  std::smatch parts;
  return std::regex_search(type, parts, list) ? parts[1].str() : std::string();
}

bool ContractTypes::is_bool(const std::string& type) { return bare(type) == "bool"; }

}  // namespace tumble::judge
