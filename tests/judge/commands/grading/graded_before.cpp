#include "judge/commands/grading/graded_before.hpp"

#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "judge/verdict/json.hpp"
#include "support/printable.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

using nlohmann::ordered_json;

namespace {

/// What the file of the submissions says.
struct KeptSubmissions {
  std::vector<fs::path> folders;
  std::optional<std::string> from;
};

KeptSubmissions kept_submissions(const GradesFolder& folder) {
  if (!fs::exists(folder.submissions())) return {};
  try {
    const ordered_json j = ordered_json::parse(support::read_text(folder.submissions()));
    KeptSubmissions kept;
    for (const ordered_json& each : j.at("folders"))
      kept.folders.emplace_back(each.get<std::string>());
    if (j.contains("from")) kept.from = j.at("from");
    return kept;
  } catch (const std::exception& error) {
    throw std::runtime_error(folder.submissions().string() +
                             " cannot be understood (./tumble grade writes it; you can delete "
                             "it): " +
                             error.what());
  }
}

void write_or_remove(const fs::path& file, const std::optional<std::string>& text) {
  std::error_code was_not_there;
  if (text)
    support::write_text(file, *text);
  else
    fs::remove(file, was_not_there);
}

/// The keys of course.json that mean other grades.
std::string keys_that_differ(const std::string& before, const std::string& now) {
  const auto object = [](const std::string& text) {
    const nlohmann::json j = nlohmann::json::parse(text, nullptr, false);
    return j.is_object() ? j : nlohmann::json::object();
  };
  const nlohmann::json a = object(before), b = object(now);
  std::set<std::string> keys;
  for (const nlohmann::json* each : {&a, &b})
    for (const auto& [key, value] : each->items()) keys.insert(key);
  std::string differing;
  for (const std::string& key : keys)
    if (key != "$schema" && a.value(key, nlohmann::json()) != b.value(key, nlohmann::json()))
      differing += (differing.empty() ? "" : ", ") + key;
  return differing;
}

/// "course.json differs in weights from grades/course.json"; empty if it does not.
std::string difference_of_settings(const GradeOptions& options, const GradesFolder& folder) {
  if (!options.settings) return "";
  const bool has = fs::exists(folder.settings());
  const std::string keys = keys_that_differ(has ? support::read_text(folder.settings()) : "{}",
                                            support::read_text(*options.settings));
  return keys.empty() ? ""
                      : options.settings->string() + " differs in " + keys + " from " +
                            (has ? folder.settings().string() : "the defaults");
}

std::string difference_of_rosters(const GradeOptions& options, const GradesFolder& folder) {
  const bool has = fs::exists(folder.roster());
  const bool is_known = has || fs::exists(folder.submissions());  // older versions kept none
  if (!options.roster || !is_known) return "";
  if (has && support::read_text(folder.roster()) == support::read_text(*options.roster)) return "";
  return options.roster->string() + " differs from " +
         (has ? folder.roster().string() : "no roster");
}

}  // namespace

std::optional<std::string> text_of(const std::optional<fs::path>& file) {
  if (!file) return std::nullopt;
  return support::read_text(*file);
}

GradeOptions as_before(GradeOptions options, std::string& taken) {
  const GradesFolder folder{options.out};
  KeptSubmissions kept = kept_submissions(folder);
  const auto take = [&](const std::string& what) { taken += (taken.empty() ? "" : ", ") + what; };
  if (options.folders.empty()) {
    options.folders = std::move(kept.folders);
    for (const fs::path& each : options.folders) take("DIR " + each.string());
  }
  if (!options.from && kept.from) take("--from " + *(options.from = kept.from));
  const auto take_file = [&](std::optional<fs::path>& given, const fs::path& own,
                             const char* option) {
    if (given || !fs::exists(own)) return;
    given = own;
    take(std::string(option) + " " + own.string());
  };
  take_file(options.settings, folder.settings(), "--course");
  take_file(options.roster, folder.roster(), "--roster");
  return options;
}

void say_what_differs(const GradeOptions& options) {
  const GradesFolder folder{options.out};
  if (!fs::exists(folder.submissions()) && !fs::exists(folder.class_list())) return;
  const bool is_part = !options.only.empty() || !options.students.empty();
  const auto say = [&](const std::string& difference, const char* option) {
    if (difference.empty()) return;
    require(!is_part, difference, ", with which the class was graded: that changes the grades of ",
            "students who are not judged now. Leave out ", option, ", or --only and --student");
    std::cerr << "tumble: " << support::printable(difference)
              << ", with which the class was graded before\n";
  };
  say(difference_of_settings(options, folder), "--course");
  say(difference_of_rosters(options, folder), "--roster");
}

void keep(const GradesFolder& folder, const GradeOptions& options) {
  ordered_json j{{"schema", "tumble/submissions/1"}, {"folders", ordered_json::array()}};
  for (const fs::path& each : options.folders) j["folders"].push_back(fs::absolute(each).string());
  if (options.from) j["from"] = *options.from;
  support::write_text(folder.submissions(), text_of(j));
  keep_files(folder, text_of(options.settings), text_of(options.roster));
}

void keep_files(const GradesFolder& folder, const std::optional<std::string>& settings,
                const std::optional<std::string>& roster) {
  write_or_remove(folder.settings(), settings);
  write_or_remove(folder.roster(), roster);
}

}  // namespace tumble::judge
