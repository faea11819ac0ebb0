#pragma once
/// @file
/// The structs and enumerations of a contract, so that values can be shown with the names they have
/// there. Contracts are written one member or enumerator a line, which is what is read.

#include <map>
#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

struct ContractMember {
  std::string type, name;
};

class ContractTypes {
 public:
  /// Reads the contract of a unit, and those that it includes.
  ContractTypes(const Course& course, const Unit& unit);

  /// The members of a struct, in order; empty if `type` is none. A type may have const, & and a
  /// namespace: "const rigid_body::Body&".
  const std::vector<ContractMember>& members_of(const std::string& type) const;
  /// The words for the values 0, 1, … of an enumeration; empty if `type` is none.
  const std::vector<std::string>& enumerators_of(const std::string& type) const;
  /// "Mesh" of "std::vector<Mesh>"; empty if `type` is not a list.
  static std::string element_of(const std::string& type);
  static bool is_bool(const std::string& type);

 private:
  void read(const fs::path& contract);

  std::map<std::string, std::vector<ContractMember>> structs_;
  std::map<std::string, std::vector<std::string>> enumerations_;
};

}  // namespace tumble::judge
