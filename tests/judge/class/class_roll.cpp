#include "judge/class/class_roll.hpp"

#include <nlohmann/json.hpp>

namespace tumble::judge {

using nlohmann::ordered_json;

namespace {

/// A text, or the numbers of its bytes if it is not UTF-8: a name of a folder need not be.
ordered_json json_of(const std::string& text) {
  try {
    ordered_json j(text);
    (void)j.dump();
    return j;
  } catch (const ordered_json::type_error&) {
    return std::vector<unsigned char>(text.begin(), text.end());
  }
}

std::string text_in(const ordered_json& j) {
  if (j.is_string()) return j;
  const auto bytes = j.get<std::vector<unsigned char>>();
  return {bytes.begin(), bytes.end()};
}

/// What is not known is not written.
void add(ordered_json& j, const char* key, const std::string& text) {
  if (!text.empty()) j[key] = json_of(text);
}

std::string text_in(const ordered_json& j, const char* key) {
  return j.contains(key) ? text_in(j.at(key)) : "";
}

void add(ordered_json& j, const Identity& who) {
  add(j, "name", who.name);
  add(j, "id", who.id);
  add(j, "email", who.email);
}

Identity identity_of(const ordered_json& j) {
  return {text_in(j, "name"), text_in(j, "id"), text_in(j, "email")};
}

ordered_json json_of(const Submission& submission) {
  ordered_json j{{"student", json_of(submission.student)}};
  add(j, submission.who);
  add(j, "answer_under", submission.answer_under);
  if (submission.attempt > 0) j["attempt"] = submission.attempt;
  return j;
}

Submission submission_of(const ordered_json& j) {
  Submission submission;
  submission.student = text_in(j.at("student"));
  submission.who = identity_of(j);
  submission.answer_under = text_in(j, "answer_under");
  submission.attempt = j.value("attempt", std::size_t{0});
  return submission;
}

ordered_json json_of(const Member& member) {
  ordered_json j = ordered_json::object();
  add(j, member.who);
  add(j, "login", member.login);
  return j;
}

Member member_of(const ordered_json& j) {
  Member member;
  member.who = identity_of(j);
  member.login = text_in(j, "login");
  return member;
}

}  // namespace

ordered_json json_of(const ClassRoll& roll) {
  ordered_json j{{"from", name_of(roll.lms)},
                 {"submissions", ordered_json::array()},
                 {"missing", ordered_json::array()},
                 {"strangers", ordered_json::array()}};
  for (const Submission& each : roll.submissions) j["submissions"].push_back(json_of(each));
  for (const Member& each : roll.match.missing) j["missing"].push_back(json_of(each));
  for (const std::string& each : roll.match.strangers) j["strangers"].push_back(json_of(each));
  if (roll.roster) j["roster"] = json_of(roll.roster_text);
  return j;
}

ClassRoll class_roll_of(const ordered_json& j) {
  ClassRoll roll;
  roll.lms = lms_named(j.at("from"));
  for (const ordered_json& each : j.at("submissions"))
    roll.submissions.push_back(submission_of(each));
  for (const ordered_json& each : j.at("missing")) roll.match.missing.push_back(member_of(each));
  for (const ordered_json& each : j.at("strangers")) roll.match.strangers.push_back(text_in(each));
  if (j.contains("roster")) {
    roll.roster_text = text_in(j, "roster");
    roll.roster = roster_in(roll.roster_text, "the roster");
  }
  return roll;
}

}  // namespace tumble::judge
