#include "judge/verdict/typed_text.hpp"

#include <algorithm>
#include <cmath>

#include "judge/spec/demand.hpp"
#include "judge/verdict/number_text.hpp"

namespace tumble::judge {

namespace {

constexpr std::size_t most_elements = 4;  // of a list of structs that are shown

/// A truth value or an enumerator as its word; empty if `type` is neither.
std::string word_for(const Value& value, const ContractTypes& types, const std::string& type) {
  const std::int64_t* n = value.as<std::int64_t>();
  if (!n) return {};
  if (ContractTypes::is_bool(type))
    return *n == 0 ? "false" : *n == 1 ? "true" : "neither true nor false";
  const std::vector<std::string>& words = types.enumerators_of(type);
  return *n >= 0 && static_cast<std::size_t>(*n) < words.size()
             ? words[static_cast<std::size_t>(*n)]
             : std::string();
}

/// The parts of a struct, if `value` has as many as `type`.
const List* parts_of(const Value& value, const std::vector<ContractMember>& members) {
  const List* list = value.as<List>();
  return list && !members.empty() && list->size() == members.size() ? list : nullptr;
}

/// Whether values of this type are shown with names of the contract, in whatever depth.
bool has_names(const ContractTypes& types, const std::string& type) {
  if (ContractTypes::is_bool(type) || !types.enumerators_of(type).empty() ||
      !types.members_of(type).empty())
    return true;
  const std::string element = ContractTypes::element_of(type);
  return !element.empty() && has_names(types, element);
}

std::string text_of_rest(std::size_t size) {
  return "… " + std::to_string(size) + " entries in all";
}

/// On one line: "{x = (0, 0, 1), scene = {gravity = true}}".
std::string inline_text(const Value& value, const ContractTypes& types, const std::string& type,
                        int digits) {
  if (std::string word = word_for(value, types, type); !word.empty()) return word;
  const std::vector<ContractMember>& members = types.members_of(type);
  if (const List* parts = parts_of(value, members)) {
    std::string text = "{";
    for (std::size_t i = 0; i < members.size(); ++i)
      text += (i > 0 ? ", " : "") + members[i].name + " = " +
              inline_text((*parts)[i], types, members[i].type, digits);
    return text + "}";
  }
  const std::string element = ContractTypes::element_of(type);
  const List* list = value.as<List>();
  if (!list || !has_names(types, element)) return text_of(value, digits, 0);
  std::string text = "(";
  for (std::size_t i = 0; i < std::min(list->size(), most_elements); ++i)
    text += (i > 0 ? ", " : "") + inline_text((*list)[i], types, element, digits);
  if (list->size() > most_elements) text += ", " + text_of_rest(list->size());
  return text + ")";
}

/// A list of structs, one a line: "[0] {x = 1, y = 2}".
std::string lines_of_list(const List& list, const ContractTypes& types, const std::string& element,
                          int digits, std::size_t indent) {
  const std::string new_line = "\n" + std::string(indent, ' ');
  std::string text;
  for (std::size_t i = 0; i < std::min(list.size(), most_elements); ++i)
    text += (i > 0 ? new_line : "") + "[" + std::to_string(i) + "] " +
            inline_text(list[i], types, element, digits);
  return list.size() > most_elements ? text + new_line + text_of_rest(list.size()) : text;
}

/// In as many lines as it takes: a matrix has its rows, a list of structs its elements.
std::string block_text(const Value& value, const ContractTypes& types, const std::string& type,
                       int digits, std::size_t indent) {
  if (!has_names(types, type)) return text_of(value, digits, indent);
  const std::string element = ContractTypes::element_of(type);
  const List* list = value.as<List>();
  return list && !list->empty() && !types.members_of(element).empty()
             ? lines_of_list(*list, types, element, digits, indent)
             : inline_text(value, types, type, digits);
}

}  // namespace

std::string TypedText::of(const Value& value) const {
  const std::vector<ContractMember>& members = types.members_of(type);
  const List* parts = parts_of(value, members);
  if (!parts) return block_text(value, types, type, digits, indent);
  std::size_t width = 0;
  for (const ContractMember& member : members) width = std::max(width, member.name.size());
  std::string text;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const ContractMember& member = members[i];
    const std::size_t inner = indent + width + 3;
    text += (i > 0 ? "\n" + std::string(indent, ' ') : "") + member.name +
            std::string(width - member.name.size(), ' ') + " = " +
            block_text((*parts)[i], types, member.type, digits, inner);
    if (member.name == marked) text += "   ← furthest off";
  }
  return text;
}

std::string hidden_difference(const TypedText& text, const Value& answer, const Value& demanded,
                              double tolerance) {
  const List *a = answer.as<List>(), *d = demanded.as<List>();
  if (!a || !d || !text.types.members_of(text.type).empty()) return {};
  const std::string element = ContractTypes::element_of(text.type);
  const std::size_t common = std::min(a->size(), d->size());
  std::size_t i = 0;
  while (i < common && largest_difference((*a)[i], (*d)[i]) <= tolerance) ++i;
  if (i == common || i < (has_names(text.types, element) ? most_elements : most_numbers_shown))
    return {};
  return "[" + std::to_string(i) + "] " + inline_text((*a)[i], text.types, element, text.digits) +
         ", demanded " + inline_text((*d)[i], text.types, element, text.digits);
}

std::string furthest_member(const ContractTypes& types, const std::string& type, const Value& a,
                            const Value& b) {
  const std::vector<ContractMember>& members = types.members_of(type);
  const List *x = parts_of(a, members), *y = parts_of(b, members);
  if (!x || !y) return {};
  std::string furthest;
  double worst = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const double apart = largest_difference((*x)[i], (*y)[i]);
    if (!(worse(worst, apart) == worst) && !std::isnan(worst)) {
      worst = apart;
      furthest = members[i].name;
    }
  }
  return members.size() > 1 ? furthest : std::string();
}

}  // namespace tumble::judge
