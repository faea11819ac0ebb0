#pragma once
/// @file
/// What platforms demand of results: their schemas' rules, and those that are said beside them.

#include <doctest/doctest.h>

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

namespace tumble::test {

using nlohmann::json;

namespace detail {

inline void check_keys(const json& object, std::initializer_list<const char*> required,
                       std::initializer_list<const char*> allowed) {
  REQUIRE(object.is_object());
  std::set<std::string> known(required.begin(), required.end());
  for (const char* key : required) CHECK_MESSAGE(object.contains(key), key);
  known.insert(allowed.begin(), allowed.end());
  for (const auto& [key, value] : object.items()) {
    const std::string name = key;
    CHECK_MESSAGE(known.count(name) > 0, name);
  }
}

inline bool one_of(const json& value, std::initializer_list<const char*> words) {
  for (const char* word : words)
    if (value == word) return true;
  return false;
}

inline bool is_count(const json& value) { return value.is_number_integer() && value >= 0; }

inline bool is_text(const json& value) { return value.is_string() && value != ""; }

inline bool matches(const json& value, const char* pattern) {
  return value.is_string() && std::regex_match(value.get<std::string>(), std::regex(pattern));
}

/// An image that a browser shows without asking anybody for it. (std::regex overflows the stack on
/// long texts.)
inline bool is_image(const json& value) {
  if (!value.is_string()) return false;
  const std::string url = value;
  const std::size_t comma = url.find(',');
  if (comma == std::string::npos ||
      !matches(url.substr(0, comma + 1), "data:image/(png|svg\\+xml);base64,"))
    return false;
  const std::size_t end = url.find_first_not_of(
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/", comma + 1);
  const std::string padding = end == std::string::npos ? "" : url.substr(end);
  return (url.size() - comma - 1) % 4 == 0 &&
         (padding.empty() || padding == "=" || padding == "==");
}

}  // namespace detail

/// Gradescope, "Autograder Specifications", "Output format".
inline void check_gradescope(const json& j) {
  detail::check_keys(
      j, {"tests"},
      {"score", "execution_time", "output", "output_format", "test_output_format",
       "test_name_format", "visibility", "stdout_visibility", "extra_data", "leaderboard"});
  const auto visibility = {"hidden", "after_due_date", "after_published", "visible"};
  CHECK(detail::one_of(j.at("visibility"), visibility));
  CHECK(detail::one_of(j.at("stdout_visibility"), visibility));
  for (const json& test : j.at("tests")) {
    detail::check_keys(test, {"score", "max_score", "status", "name", "visibility"},
                       {"name_format", "number", "output", "output_format", "tags", "extra_data"});
    CHECK(test.at("score").is_number());
    CHECK(test.at("score") >= 0);
    CHECK(test.at("score") <= test.at("max_score"));
    CHECK(detail::one_of(test.at("status"), {"passed", "failed"}));
    CHECK(detail::one_of(test.at("visibility"), visibility));
  }
}

/// PrairieLearn, "External grading", "Grading results": at most 1 MB, points on every test.
inline void check_prairielearn(const std::string& text) {
  CHECK(text.size() <= 1'000'000);
  const json j = json::parse(text);
  detail::check_keys(j, {"gradable"},
                     {"score", "format_errors", "message", "output", "images", "tests"});
  REQUIRE(j.at("gradable").is_boolean());
  if (!j.at("gradable")) return;
  CHECK(j.at("score") >= 0);
  CHECK(j.at("score") <= 1);
  for (const json& test : j.at("tests")) {
    detail::check_keys(test, {"name", "points", "max_points"},
                       {"description", "message", "output", "images"});
    CHECK(test.at("points") <= test.at("max_points"));
  }
  if (j.contains("images"))
    for (const json& image : j.at("images")) {
      detail::check_keys(image, {"url"}, {"label"});
      CHECK(detail::is_image(image.at("url")));
    }
}

/// PrairieLearn, infoQuestion.json, and the longest time that the grader gives.
inline void check_prairielearn_question(const json& j) {
  detail::check_keys(j, {"uuid", "title", "topic", "type"},
                     {"tags", "gradingMethod", "singleVariant", "partialCredit",
                      "showCorrectAnswer", "externalGradingOptions"});
  CHECK(detail::matches(j.at("uuid"), "[0-9a-f]{8}-([0-9a-f]{4}-){3}[0-9a-f]{12}"));
  CHECK(j.at("type") == "v3");
  CHECK(j.at("gradingMethod") == "External");
  const json& grader = j.at("externalGradingOptions");
  detail::check_keys(grader, {"image", "entrypoint"},
                     {"serverFilesCourse", "timeout", "enableNetworking", "environment"});
  CHECK(detail::is_count(grader.at("timeout")));
  CHECK(grader.at("timeout") <= 600);
  CHECK(grader.at("entrypoint").at(0).get<std::string>().starts_with("/"));
}

/// Classroom 50, result-v1.schema.json and what its runner looks at besides.
inline void check_classroom50(const json& j) {
  detail::check_keys(j,
                     {"schema", "classroom", "assignment", "assignment_type", "owner", "submission",
                      "commit", "release", "review", "datetime", "score", "max-score", "tests"},
                     {"graded_at", "submitted_by"});
  CHECK(j.at("schema") == "classroom50/result/v1");
  CHECK(detail::one_of(j.at("assignment_type"), {"individual", "group", "team"}));
  for (const char* key : {"classroom", "assignment", "owner", "commit", "release", "review"})
    CHECK_MESSAGE(detail::is_text(j.at(key)), key);
  CHECK(detail::matches(j.at("submission"), "submit/.+"));
  CHECK(detail::matches(j.at("datetime"), R"(\d{4}-\d{2}-\d{2}T([01]\d|2[0-3]):[0-5]\d:[0-5]\dZ)"));
  long score = 0, most = 0;
  for (const json& test : j.at("tests")) {
    CHECK(detail::is_text(test.at("test-name")));
    CHECK(test.at("passed").is_boolean());
    CHECK(detail::is_count(test.at("score")));
    CHECK(detail::is_count(test.at("max-score")));
    CHECK(test.at("score") <= test.at("max-score"));
    score += test.at("score").get<long>();
    most += test.at("max-score").get<long>();
  }
  CHECK(j.at("score") == score);
  CHECK(j.at("max-score") == most);
}

/// Classroom 50, an entry of assignments-v1.schema.json, as far as it is written here.
inline void check_classroom50_assignment(const json& j) {
  detail::check_keys(j, {"slug", "name", "mode", "autograder"},
                     {"template", "due", "release_assets"});
  CHECK(detail::matches(j.at("slug"), "[a-z0-9][a-z0-9-]{1,38}"));
  CHECK(j.at("mode") == "individual");
  CHECK(j.at("autograder") == "default");
  detail::check_keys(j.at("template"), {"owner", "repo", "branch"}, {});
  if (j.contains("due"))
    CHECK(detail::matches(j.at("due"),
                          R"(\d{4}-\d{2}-\d{2}T([01]\d|2[0-3]):[0-5]\d:[0-5]\d(\.\d+)?)"
                          R"((Z|[+-]([01]\d|2[0-3]):[0-5]\d))"));
  if (j.contains("release_assets"))
    for (const json& asset : j.at("release_assets"))
      CHECK(detail::matches(asset, "[A-Za-z0-9_-][A-Za-z0-9._-]*[A-Za-z0-9_-]"));
}

}  // namespace tumble::test
