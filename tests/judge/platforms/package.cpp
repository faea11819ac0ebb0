#include "judge/platforms/package.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>

#include "judge/handout/handout.hpp"
#include "judge/platforms/platform.hpp"
#include "judge/platforms/prairielearn_question.hpp"
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

/// Lower case, digits and hyphens: a name for folders and addresses.
std::string slug_of(const std::string& title) {
  std::string slug;
  for (const char c : title) {
    const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if ((lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9'))
      slug += lower;
    else if (!slug.empty() && slug.back() != '-')
      slug += '-';
  }
  while (!slug.empty() && slug.back() == '-') slug.pop_back();
  return slug.size() < 2 ? "tumble" : slug.substr(0, 39);
}

/// Classroom 50 wants them, course.json does not.
std::string with_seconds(std::string time) {
  return time[16] == ':' ? time : time.insert(16, ":00");
}

/// Everything that packages have in common.
class Package {
 public:
  Package(const Course& course, const std::optional<fs::path>& file, const std::string& image,
          fs::path to)
      : course_(course),
        settings_(settings_or_default(course, file)),
        json_(file ? ordered_json::parse(support::read_text(*file)) : ordered_json::object()),
        to_(std::move(to)) {
    require(!fs::exists(to_) || (fs::is_directory(to_) && fs::is_empty(to_)), to_.string(),
            " exists already: nothing is overwritten");
    if (!json_.contains("seed")) json_["seed"] = std::random_device{}();
    // A function may call those of earlier chapters, and an engine takes functions of all.
    const bool curve = settings_.wants_curve(course);
    const std::string last = (curve ? course.units : settings_.units).back().chapter;
    for (const Unit& unit : course.units) {
      all_chapters_.insert(unit.chapter);
      if (unit.chapter <= last) chapters_.insert(unit.chapter);
    }
    char points[32];
    std::snprintf(points, sizeof points, "%g", settings_.most());
    words_ = {
        {"TITLE", settings_.title},
        {"POINTS", points},
        {"QID", slug_of(settings_.title)},
        {"IMAGE", image},
        {"CURVE", curve ? ", and `engine.svg` with the curves of the student's own engine" : ""}};
  }

  void gradescope() {
    const fs::path zip = to_ / "zip", here = fs::current_path();
    make_tree(course_, {chapters_, true}, zip / "tumble");
    write_settings(zip / "tumble");
    for (const char* script : {"setup.sh", "run_autograder"}) copy(script, zip);
    fs::current_path(zip);  // then no path has to be told to a shell
    const int status = std::system("'" TUMBLE_CMAKE
                                   "' -E tar cf ../autograder.zip --format=zip "
                                   "setup.sh run_autograder tumble");
    fs::current_path(here);
    require(status == 0, "making autograder.zip has failed, see above");
    fs::remove_all(zip);
    copy("README.md", to_);
  }

  void prairielearn() {
    const fs::path question = to_ / "question";
    words_.merge(write_question(course_, settings_, words_.at("IMAGE"), question));
    copy("question.html", question);
    for (const Unit& unit : course_.units)
      support::write_text_and_folders(
          question / "tests" / "solutions" / unit.chapter / (unit.name + ".cpp"),
          support::read_text(course_.solution(unit)));
    write_settings(question / "tests");
    make_tree(course_, {all_chapters_, false}, to_ / "image" / "tumble");  // for every question
    copy("Dockerfile", to_ / "image");
    copy("README.md", to_);
  }

  void classroom50() {
    make_tree(course_, {chapters_, false}, to_ / "template");
    const fs::path bundle = to_ / "bundle";
    make_tree(course_, {chapters_, false}, bundle / "tumble");
    write_settings(bundle);
    copy("autograder.py", bundle);
    support::write_text_and_folders(to_ / "assignment.json", text_of(assignment()));
    copy("README.md", to_);
  }

  void github_actions() {
    const fs::path repository = to_ / "repository";
    make_tree(course_, {chapters_, false}, repository);
    write_settings(repository);
    support::write_text_and_folders(repository / ".github" / "workflows" / "tumble.yml",
                                    support::read_text(packages() / "workflow.yml"));
    copy("README.md", to_);
  }

  void make(const std::string& platform) {
    using Maker = void (Package::*)();
    static const std::map<std::string, Maker> makers = {
        {"gradescope", &Package::gradescope},
        {"prairielearn", &Package::prairielearn},
        {"classroom50", &Package::classroom50},
        {"github-actions", &Package::github_actions}};
    const auto maker = makers.find(platform);
    require(maker != makers.end(), "there is no platform '", platform, "'; there are: ", platforms);
    platform_ = platform;
    (this->*maker->second)();
  }

 private:
  fs::path packages() const {
    return course_.root / "tests" / "judge" / "platforms" / "packages" / platform_;
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
  CourseSettings settings_;
  ordered_json json_;  ///< course.json as it was, with a seed
  fs::path to_;
  std::string platform_;
  std::set<std::string> chapters_, all_chapters_;  ///< those up to the last that counts, and all
  Words words_;
};

}  // namespace

void make_package(const Course& course, const std::string& platform,
                  const std::optional<fs::path>& file, const std::string& image,
                  const fs::path& to) {
  Package(course, file, image, to).make(platform);
}

}  // namespace tumble::judge
