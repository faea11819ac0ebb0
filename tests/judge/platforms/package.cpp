#include "judge/platforms/package.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>

#include "judge/class/settings.hpp"
#include "judge/class/tools.hpp"
#include "judge/handout/handout.hpp"
#include "judge/platforms/image_name.hpp"
#include "judge/platforms/platform.hpp"
#include "judge/platforms/prairielearn_question.hpp"
#include "judge/platforms/slug.hpp"
#include "judge/platforms/time_limits.hpp"
#include "judge/verdict/json.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

using nlohmann::ordered_json;

/// A text with each @NAME@ replaced.
std::string filled(std::string text, const Words& words) {
  for (const auto& [name, word] : words) {
    const std::string place = "@" + name + "@";
    for (std::size_t at = 0; (at = text.find(place, at)) != std::string::npos; at += word.size())
      text.replace(at, place.size(), word);
  }
  return text;
}

/// Classroom 50 wants them, course.json does not.
std::string with_seconds(std::string time) {
  return time[16] == ':' ? time : time.insert(16, ":00");
}

std::string points_text(double points) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", points);
  return text;
}

/// "1 point", "7 points".
std::string how_many_points(double points) {
  return points_text(points) + (points == 1 ? " point" : " points");
}

/// The last chapter whose functions are needed: a function may call those of earlier chapters, and
/// an engine takes functions of all.
std::string last_chapter(const Course& course, const CourseSettings& settings) {
  return (settings.wants_curve(course) ? course.units : settings.units).back().chapter;
}

/// Everything that packages have in common.
class Package {
 public:
  Package(const Course& course, const PackageOrder& order)
      : course_(course),
        order_(order),
        settings_(settings_or_default(course, order.settings)),
        json_(order.settings ? ordered_json::parse(support::read_text(*order.settings))
                             : ordered_json::object()) {
    require(!fs::exists(order.to) || (fs::is_directory(order.to) && fs::is_empty(order.to)),
            order.to.string(), " exists already: nothing is overwritten");
    require(!order.each || order.platform == "prairielearn",
            "--each is for PrairieLearn: elsewhere one package takes all exercises");
    if (!json_.contains("seed")) json_["seed"] = std::random_device{}();
    const bool curve = settings_.wants_curve(course);
    const std::string last = last_chapter(course, settings_);
    for (const Unit& unit : course.units) {
      all_chapters_.insert(unit.chapter);
      if (unit.chapter <= last) chapters_.insert(unit.chapter);
    }
    words_ = {
        {"TITLE", settings_.title},
        {"POINTS", how_many_points(settings_.most())},
        {"QID", slug_of(settings_.title)},
        {"CURVE", curve ? ", and `engine.svg` with the curves of the student's own engine" : ""}};
  }

  void gradescope() {
    set_limits(600, 2400);
    const fs::path zip = order_.to / "zip", here = fs::current_path();
    make_tree(course_, {chapters_, true}, zip / "tumble");
    write_settings(zip / "tumble");
    for (const char* script : {"setup.sh", "run_autograder"}) copy(script, zip);
    fs::current_path(zip);  // then no path has to be told to a shell
    const int status = std::system(("'" + std::string(cmake_program) +
                                    "' -E tar cf ../autograder.zip --format=zip "
                                    "setup.sh run_autograder tumble")
                                       .c_str());
    fs::current_path(here);
    require(status == 0, "making autograder.zip has failed, see above");
    fs::remove_all(zip);
    copy("README.md", order_.to);
  }

  void prairielearn() {
    require_image_name(order_.image);
    words_["IMAGE"] = order_.image;
    if (order_.each)
      questions();
    else
      question(settings_, json_, order_.to / "question");
    words_["COPY"] = order_.each
                         ? "the contents of `questions/` into your course's `questions/`"
                         : "`question/` into your course as `questions/" + words_.at("QID") + "/`";
    words_["ASSESS"] = order_.each ? "the questions into an assessment, with partial credit: "
                                     "`zones.json` has their names and points"
                                   : "the question into an assessment with " + words_.at("POINTS") +
                                         " and partial credit";
    make_tree(course_, {all_chapters_, false}, order_.to / "image" / "tumble");  // for all
    copy("Dockerfile", order_.to / "image");
    copy("README.md", order_.to);
  }

  void classroom50() {
    make_public();
    set_limits(900, 900);
    make_tree(course_, {chapters_, false}, order_.to / "template");
    const fs::path bundle = order_.to / "bundle";
    make_tree(course_, {chapters_, false}, bundle / "tumble");
    write_settings(bundle);
    copy("autograder.py", bundle);
    support::write_text_and_folders(order_.to / "assignment.json", text_of(assignment()));
    copy("README.md", order_.to);
  }

  void github_actions() {
    make_public();
    set_limits(600, 21'600);
    const fs::path repository = order_.to / "repository";
    make_tree(course_, {chapters_, false}, repository);
    write_settings(repository);
    copy("tumble.yml", repository / ".github" / "workflows");
    copy("README.md", order_.to);
  }

  std::vector<std::string> make() {
    using Maker = void (Package::*)();
    static const std::map<std::string, Maker> makers = {
        {"gradescope", &Package::gradescope},
        {"prairielearn", &Package::prairielearn},
        {"classroom50", &Package::classroom50},
        {"github-actions", &Package::github_actions}};
    (this->*makers.at(order_.platform))();
    return notes_;
  }

 private:
  fs::path packages() const {
    return course_.root / "tests" / "judge" / "platforms" / "packages" / order_.platform;
  }

  /// A file of the platform's folder, its words filled in.
  void copy(const std::string& name, const fs::path& folder) const {
    const fs::path from = packages() / name;
    support::write_text_and_folders(folder / name, filled(support::read_text(from), words_));
    fs::permissions(folder / name, fs::status(from).permissions());
  }

  void write_settings(const fs::path& folder) const {
    support::write_text_and_folders(folder / "course.json", text_of(json_));
  }

  void set_limits(int usual, int most) {
    const TimeLimits limits = time_limits(usual, most, order_.limit);
    words_["DEADLINE"] = std::to_string(limits.deadline);
    words_["LIMIT"] = std::to_string(limits.limit);
    words_["MINUTES"] = std::to_string((limits.limit + 59) / 60);
  }

  /// What students can read holds nothing that they should not know.
  void make_public() {
    require(
        settings_.hidden.empty(), order_.platform,
        " hides nothing: students can read the package and all that it writes. Leave \"hidden\" "
        "out of the course.json of this package, or those exercises out of its \"units\"");
    if (settings_.seed) {
      json_["seed"] = std::random_device{}();
      notes_.emplace_back(
          "students can read this package: its course.json has a seed of its own; keep yours "
          "secret");
    }
    leave_out_students();
  }

  /// Of course.json only what is about exercises: what else there is, or ever comes, may name
  /// students.
  void leave_out_students() {
    static const std::set<std::string> about_exercises = {"$schema", "title",   "units", "weights",
                                                          "credit",  "due",     "seed",  "curve",
                                                          "late",    "several", "extra"};
    ordered_json kept = ordered_json::object();
    std::string left_out;
    for (const auto& [key, value] : json_.items())
      if (about_exercises.contains(key))
        kept[key] = value;
      else
        left_out += (left_out.empty() ? "" : ", ") + ("\"" + key + "\"");
    json_ = std::move(kept);
    if (!left_out.empty())
      notes_.push_back("students can read this package: " + left_out +
                       " of your course.json are left out of it, because they name students; "
                       "./tumble grade --course with yours applies them");
  }

  /// One question, with what its grader needs and students do not see.
  void question(const CourseSettings& settings, const ordered_json& json, const fs::path& folder) {
    Words words = words_;
    words.merge(write_question(course_, settings, {order_.image, order_.limit}, folder));
    support::write_text(folder / "question.html",
                        filled(support::read_text(packages() / "question.html"), words));
    const std::string last = last_chapter(course_, settings);
    for (const Unit& unit : course_.units)
      if (unit.chapter <= last)
        support::write_text_and_folders(
            folder / "tests" / "solutions" / unit.chapter / (unit.name + ".cpp"),
            support::read_text(course_.solution(unit)));
    support::write_text(folder / "tests" / "course.json", text_of(json));
  }

  /// A question for each unit, and a list of them for an assessment.
  void questions() {
    ordered_json list = ordered_json::array();
    double extra = 0;
    for (const Unit& unit : settings_.units) {
      if (settings_.points(unit) == 0) continue;
      CourseSettings settings = settings_;
      settings.title += ": " + unit.number + " " + unit.name;
      settings.units = {unit};
      ordered_json json = json_;
      json["title"] = settings.title;
      json["units"] = {unit.number};
      json["weights"] = {{unit.number, settings_.points(unit)}};
      json.erase("hidden");
      json.erase("extra");  // of its own question it is all; extra is what the assessment makes it
      settings.rules.extra.clear();
      if (settings_.hidden.contains(unit.id())) json["hidden"] = {unit.number};
      const std::string id = words_.at("QID") + "/" + slug_of(unit.number + " " + unit.name);
      question(settings, json, order_.to / "questions" / id);
      list.push_back({{"id", id}, {"points", settings_.points(unit)}});
      if (settings_.rules.extra.contains(unit.id())) extra += settings_.points(unit);
    }
    if (extra > 0)
      notes_.push_back("extra points are PrairieLearn's to add: write \"maxPoints\": " +
                       points_text(settings_.most()) + " and \"maxBonusPoints\": " +
                       points_text(extra) + " into the assessment's infoAssessment.json");
    support::write_text(order_.to / "zones.json",
                        text_of({{"zones", {{{"questions", std::move(list)}}}}}));
  }

  ordered_json assignment() const {
    ordered_json j{{"slug", words_.at("QID")},
                   {"name", settings_.title},
                   {"mode", "individual"},
                   {"autograder", "default"},
                   {"template", {{"owner", "OWNER"}, {"repo", "REPOSITORY"}, {"branch", "main"}}}};
    if (settings_.due) j["due"] = with_seconds(*settings_.due);
    if (settings_.wants_curve(course_)) j["release_assets"] = {"engine.svg"};
    return j;
  }

  const Course& course_;
  const PackageOrder& order_;
  CourseSettings settings_;
  ordered_json json_;                              ///< course.json as it was, with a seed
  std::set<std::string> chapters_, all_chapters_;  ///< those up to the last that counts, and all
  Words words_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> make_package(const Course& course, const PackageOrder& order) {
  require_platform(order.platform);
  return Package(course, order).make();
}

}  // namespace tumble::judge
