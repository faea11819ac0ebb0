#include "judge/verdict/answer_type.hpp"

#include "judge/course/contract.hpp"
#include "judge/course/contract_types.hpp"

namespace tumble::judge {

AnswerType answer_type(const Course& course, const Unit& unit) {
  const ContractTypes types(course, unit);
  const std::string result = read_declaration(course, unit).result;
  AnswerType type;
  for (const ContractMember& member : types.members_of(result)) type.members.push_back(member.name);
  type.has_structs_in_list = !types.members_of(ContractTypes::element_of(result)).empty();
  return type;
}

}  // namespace tumble::judge
