/// @file
/// Values with the names that they have in the contract.
#include "judge/verdict/typed_text.hpp"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace tumble::judge;

namespace {

ContractTypes types_of(const std::string& chapter) {
  Course course;
  course.root = std::getenv("TUMBLE_ROOT");
  Unit unit;
  unit.chapter = chapter;
  return {course, unit};
}

std::vector<std::string> names_of(const std::vector<ContractMember>& members) {
  std::vector<std::string> names;
  for (const ContractMember& member : members) names.push_back(member.name);
  return names;
}

}  // namespace

TEST_CASE("contract types: members and enumerators, of included contracts too") {
  const ContractTypes types = types_of("10_only_what_a_scene_needs");
  using Names = std::vector<std::string>;
  CHECK(names_of(types.members_of("const Body&")) == Names{"mass", "I_body", "I_body_inv"});
  CHECK(names_of(types.members_of("rigid_body::State")) == Names{"x", "q", "P", "L"});
  CHECK(types.enumerators_of("Model") == Names{"particle", "ball", "symmetric_top", "full_body"});
  CHECK(types.members_of("double").empty());
  CHECK(names_of(types_of("08_mirtich").members_of("ProjectionIntegrals")) ==
        Names{"one", "a", "b", "aa", "ab", "bb", "aaa", "aab", "abb", "bbb"});
  CHECK(ContractTypes::element_of("const std::vector<State>&") == "State");
  CHECK(ContractTypes::element_of("Eigen::VectorXd") == "");
  CHECK(ContractTypes::is_bool("bool"));
}

TEST_CASE(
    "typed text: a line a member, the worst marked; words for truth values and enumerations") {
  const ContractTypes types = types_of("06_point_sampling");
  const Value a =
      List{2., List{1., 2., 3.}, List{List{1., 0., 0.}, List{0., 1., 0.}, List{0., 0., 1.}}};
  const Value b =
      List{2., List{1., 2., 4.}, List{List{1., 0., 0.}, List{0., 1., 0.}, List{0., 0., 1.}}};
  CHECK(furthest_member(types, "MassProperties", a, b) == "centre");
  const std::string text = TypedText{types, "MassProperties", 9, 2, "centre"}.of(a);
  CHECK(text.find("mass    = 2\n  centre  = (1, 2, 3)   ← furthest off\n  inertia = [") == 0);
  CHECK(TypedText{types, "bool", 9, 0, {}}.of(std::int64_t{1}) == "true");
  CHECK(TypedText{types, "bool", 9, 0, {}}.of(std::int64_t{254}) == "neither true nor false");
  const ContractTypes scenes = types_of("10_only_what_a_scene_needs");
  CHECK(TypedText{scenes, "Model", 9, 0, {}}.of(std::int64_t{2}) == "symmetric_top");
  CHECK(TypedText{scenes, "Model", 9, 0, {}}.of(std::int64_t{7}) == "7");
  CHECK(TypedText{scenes, "std::vector<Model>", 9, 0, {}}.of(
            List{std::int64_t{2}, std::int64_t{0}}) == "(symmetric_top, particle)");
  // A value of another shape than its type is shown as it is.
  CHECK(TypedText{types, "MassProperties", 9, 0, {}}.of(List{1., 2.}) == "(1, 2)");
}

TEST_CASE("typed text: a list of structs has a line for each, the first four") {
  const ContractTypes types = types_of("11_when_bodies_meet");
  const auto pair = [](std::int64_t a, std::int64_t b) { return Value(List{a, b}); };
  const std::string type = "std::vector<Pair>";
  CHECK(TypedText{types, type, 9, 2, {}}.of(List{}) == "()");
  CHECK(TypedText{types, type, 9, 2, {}}.of(List{pair(0, 3), pair(1, 2)}) ==
        "[0] {first = 0, second = 3}\n  [1] {first = 1, second = 2}");
  const std::string five = TypedText{types, type, 9, 2, {}}.of(List(5, pair(0, 3)));
  CHECK(hidden_difference({types, type, 9, 2, {}}, List(5, pair(0, 3)),
                          List{pair(0, 3), pair(0, 3), pair(0, 3), pair(0, 3), pair(1, 3)},
                          0) == "[4] {first = 0, second = 3}, demanded {first = 1, second = 3}");
  CHECK(hidden_difference({types, type, 9, 2, {}}, List(5, pair(0, 3)), List(5, pair(1, 3)), 0) ==
        "");
  CHECK(five.ends_with("\n  [3] {first = 0, second = 3}\n  … 5 entries in all"));
}
