#pragma once
/// @file
/// Values as a student reads them, with the names that their parts have in the contract.

#include <cstddef>
#include <string>

#include "judge/course/contract_types.hpp"
#include "judge/protocol/value.hpp"

namespace tumble::judge {

/// How a value of a contract's type is shown.
struct TypedText {
  const ContractTypes& types;
  std::string type;        ///< "std::vector<State>", "const Body&", "bool"
  int digits = 9;          ///< of a number
  std::size_t indent = 0;  ///< of further lines
  std::string marked;      ///< a member whose line gets a mark; none if empty

  /// A struct has a line for each member, truth values and enumerations are words, all else is as
  /// text_of() shows it.
  std::string of(const Value& value) const;
};

/// The first entry of a list that is not the one demanded, where the texts of both end before it:
/// "[20] 3, demanded 4". Else empty.
std::string hidden_difference(const TypedText& text, const Value& answer, const Value& demanded,
                              double tolerance);

/// The member of a struct in which two values are furthest apart; empty if `type` is no struct.
std::string furthest_member(const ContractTypes& types, const std::string& type, const Value& a,
                            const Value& b);

}  // namespace tumble::judge
