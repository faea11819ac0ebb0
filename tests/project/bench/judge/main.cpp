// Grading a class: how long it takes, that it takes nothing from the verdicts, and that a grading
// which is killed goes on. A class is made up, and graded by the program that instructors use.
#include <array>
#include <cstdlib>
#include <iostream>
#include <set>
#include <thread>

#include "judge/build/work_folder.hpp"
#include "judge/class/shard.hpp"
#include "project/bench/judge/class_cost.hpp"
#include "project/bench/judge/handed_in.hpp"
#include "project/bench/judge/program.hpp"
#include "project/bench/judge/records.hpp"
#include "support/command_line.hpp"
#include "support/table.hpp"
#include "support/text_file.hpp"

namespace tumble::bench {
namespace {

using support::number;
using support::Table;

struct Options {
  std::size_t students = 200;
  std::uint64_t seed = 1;
  std::string units = "all";
  std::size_t alone = 10;  ///< students who are also judged by themselves
  bool killed_too = true;
};

std::string load() {
  std::array<double, 1> average{};
  return getloadavg(average.data(), 1) == 1 ? number(average[0]) : "unknown";
}

/// A class, graded once and again.
class ClassBench {
 public:
  ClassBench(const Options& options, const fs::path& place)
      : options_(options),
        place_(place),
        course_(judge::read_course(TUMBLE_COURSE)),
        units_(course_.select(options.units)) {
    fs::create_directory(place / "writable");
    fs::permissions(place / "writable", fs::perms::all);
    class_ = hand_in(course_, units_,
                     {TUMBLE_ROOT "/tests/project/attacks", TUMBLE_ROOT, place / "writable"}, place,
                     options.students, options.seed);
    json settings{{"seed", options.seed}, {"units", json::array()}};
    for (const judge::Unit& unit : units_) settings["units"].push_back(unit.number);
    support::write_text(place / "course.json", settings.dump());
  }

  /// @return whether all is as it should be
  bool run() {
    std::cout << class_.students.size() << " students, " << units_.size() << " exercises, "
              << std::thread::hardware_concurrency() << " cores; load before: " << load() << "\n\n";
    std::cerr << "tumble: grading\n";
    const Cost cost = run_to_end(grade_command("grades"), place_ / "log");
    whole_ = verdicts_of_class(place_ / "grades");
    report(cost);
    report_cost_by_cores();
    merge_shards();
    if (options_.killed_too) kill_and_resume();
    judge_alone();
    return right_;
  }

 private:
  std::vector<std::string> grade_command(const std::string& out) const {
    return {TUMBLE_JUDGE, "grade",    class_.submissions,    "--out",
            place_ / out, "--course", place_ / "course.json"};
  }

  std::vector<std::string> shard_command(const std::string& out, const judge::Shard& shard) const {
    std::vector<std::string> command = grade_command(out);
    command.insert(command.end(), {"--shard", judge::name_of(shard)});
    return command;
  }

  void expect(bool holds, const std::string& what) {
    std::cout << (holds ? "  ✓ " : "  ✗ ") << what << "\n";
    right_ = right_ && holds;
  }

  void expect_none(const std::vector<std::string>& found, const std::string& what) {
    expect(found.empty(), what + ": " + std::to_string(found.size()));
    for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), 10); ++i)
      std::cout << "      " << found[i] << "\n";
  }

  std::map<std::string, const Student*> by_name() const {
    std::map<std::string, const Student*> names;
    for (const Student& student : class_.students) names[student.name] = &student;
    return names;
  }

  /// Attacks may say another number each time, or be stopped by another wall; a mistake may give
  /// what happened to be in memory.
  auto likeness(Likeness of_work) const {
    return [of_work, students = by_name()](const std::string& student, const std::string& unit) {
      const Kind kind = students.at(student)->files.at(unit);
      if (kind == Kind::attack) return Likeness::outcome;
      return kind == Kind::mistake ? Likeness::laws : of_work;
    };
  }

  /// The share of files whose text another student has handed in as well, for the same unit.
  double equal_share() const {
    std::size_t equal = 0, all = 0;
    for (const judge::Unit& unit : units_) {
      std::map<std::string, std::size_t> texts;
      for (const Student& student : class_.students)
        ++texts[support::read_text(class_.sources / student.name / (unit.id() + ".cpp"))];
      for (const auto& [text, times] : texts) equal += times - 1, all += times;
    }
    return static_cast<double>(equal) / static_cast<double>(all);
  }

  void report(const Cost& cost) const {
    const auto verdicts = static_cast<double>(count(whole_));
    Table total({"", "all", "each verdict"});
    total.add({"wall time", number(cost.wall) + " s", number(1e3 * cost.wall / verdicts) + " ms"});
    total.add({"processor time", number(cost.processor) + " s",
               number(1e3 * cost.processor / verdicts) + " ms"});
    std::cout << total.text() << "\n"
              << by_kind().text() << "\n"
              << number(100 * equal_share(), 2)
              << " % of the files have the text of another student's: the compiler sees it once.\n"
              << "load after: " << load() << "\n\n";
  }

  Table by_kind() const {
    struct Sum {
      std::size_t files = 0, passed = 0;
      double seconds = 0;
    };
    std::array<Sum, kinds> sums{};
    for (const Student& student : class_.students)
      for (const auto& [unit, kind] : student.files) {
        const json& verdict = whole_.at(student.name).at(unit);
        Sum& sum = sums[static_cast<std::size_t>(kind)];
        ++sum.files;
        sum.passed += verdict.at("passed").get<bool>() ? 1u : 0u;
        sum.seconds += verdict.at("seconds").get<double>();
      }
    Table table({"what was handed in", "files", "pass", "from file to verdict, mean"});
    for (std::size_t k = 0; k < kinds; ++k)
      if (sums[k].files > 0)
        table.add({name_of(static_cast<Kind>(k)), std::to_string(sums[k].files),
                   std::to_string(sums[k].passed),
                   number(1e3 * sums[k].seconds / static_cast<double>(sums[k].files)) + " ms"});
    return table;
  }

  /// Grades a shard of about twenty students on one core, and on two.
  void report_cost_by_cores() {
    if (cores_to_choose_from() < 2) {
      std::cout << "cost by cores: needs two of them, and a system that can take one away\n\n";
      return;
    }
    const judge::Shard shard{1, std::max<std::size_t>(1, options_.students / 20)};
    MeasuredCost measured;
    for (const Student& student : class_.students)
      measured.students += judge::holds(shard, student.name) ? 1u : 0u;
    if (measured.students == 0) return;
    const auto grade_on = [&](std::size_t cores) {
      const std::string out = "on" + std::to_string(cores);
      std::cerr << "tumble: grading shard " << judge::name_of(shard) << " on " << cores
                << (cores == 1 ? " core\n" : " cores\n");
      return run_to_end(shard_command(out, shard), place_ / "log", {0}, cores);
    };
    const Cost one = grade_on(1), two = grade_on(2);
    measured.one_core = one.wall, measured.two_cores = two.wall, measured.processor = one.processor;
    std::cout
        << cost_by_cores(measured).text() << "\n"
        << "1 and 2 cores: measured with " << measured.students
        << " of these students, in proportion. More: computed, as if each core did what those "
           "two did\nbeside each other ("
        << number(100 * measured.share_of_two(), 3)
        << " % of twice one); the machines have one shard each, all of the same size.\n\n";
  }

  /// Of the verdicts that are there: three shards, merged, are the same class.
  void merge_shards() {
    std::vector<std::string> merge = {TUMBLE_JUDGE, "grade", "--out", place_ / "merged", "--merge"};
    for (std::size_t k = 1; k <= 3; ++k) {
      const std::string out = "shard" + std::to_string(k);
      fs::create_directories(place_ / out);
      fs::copy(place_ / "grades/students", place_ / out / "students", fs::copy_options::recursive);
      run_to_end(shard_command(out, {k, 3}), place_ / "log");
      merge.push_back(place_ / out);
    }
    run_to_end(merge, place_ / "log");
    for (const char* table : {"grades.csv", "junit.xml", "identical.csv"})
      expect(support::read_text(place_ / "merged" / table) ==
                 support::read_text(place_ / "grades" / table),
             std::string("of three shards, ") + table + " is the same, byte for byte");
  }

  /// Grades until a third is done, and kills. @return what was on disk then
  ClassVerdicts grade_a_third() {
    Program grading(grade_command("killed"), place_ / "log");
    while (!grading.ended() && count(verdicts_of_class(place_ / "killed")) < count(whole_) / 3)
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    expect(!grading.ended(), "killed while it was at work");
    grading.kill();
    grading.wait();
    return verdicts_of_class(place_ / "killed");
  }

  void kill_and_resume() {
    std::cerr << "tumble: grading, to be killed\n";
    const bool adopting = adopt_orphans();
    const ClassVerdicts before = grade_a_third();
    if (adopting) expect(orphans_are_gone(), "nothing is left running");
    std::cerr << "tumble: going on\n";
    const Cost cost = run_to_end(grade_command("killed"), place_ / "log");
    const ClassVerdicts after = verdicts_of_class(place_ / "killed");
    std::cout << "    " << count(before) << " verdicts were kept; " << count(after) - count(before)
              << " more in " << number(cost.wall) << " s\n";
    expect(count(after) == count(whole_), "none is missing");
    expect_none(changed(before, after), "judged twice");
    expect_none(differences(after, whole_, likeness(Likeness::all)),
                "verdicts that differ from those of the grading without a break");
    expect(support::read_text(place_ / "killed/grades.csv") ==
               support::read_text(place_ / "grades/grades.csv"),
           "grades.csv is the same, byte for byte");
    expect(fs::is_empty(place_ / "work"), "no folder of the killed one is left");
  }

  /// Those that are not what they were, to the time that they took.
  static std::vector<std::string> changed(const ClassVerdicts& before, const ClassVerdicts& after) {
    std::vector<std::string> found;
    for (const auto& [student, verdicts] : before)
      for (const auto& [unit, verdict] : verdicts)
        if (after.at(student).at(unit) != verdict) found.push_back(student + " " + unit);
    return found;
  }

  void judge_alone() {
    std::cerr << "tumble: judging " << options_.alone << " students alone\n";
    ClassVerdicts alone;
    const std::size_t all = class_.students.size(), some = std::min(options_.alone, all);
    for (std::size_t i = 0; i < some; ++i) {
      const Student& student = class_.students[i * all / some];
      const json record =
          json::parse(support::read_text(place_ / "grades/students" / (student.name + ".json")));
      run_to_end({TUMBLE_JUDGE, "check", options_.units, "--from", class_.sources / student.name,
                  "--seed", record.at("seed").dump(), "--json", place_ / "alone.json"},
                 place_ / "log", {0, 1});
      alone[student.name] = verdicts_of_check(place_ / "alone.json");
    }
    std::cout << "\n    " << count(alone) << " verdicts of " << some
              << " students, each student judged alone\n";
    expect_none(differences(alone, whole_, likeness(Likeness::laws)),
                "verdicts that differ from those in the class");
  }

  const Options& options_;
  fs::path place_;
  judge::Course course_;
  std::vector<judge::Unit> units_;
  HandedIn class_;
  ClassVerdicts whole_;
  bool right_ = true;
};

bool run(const Options& options) {
  const judge::WorkFolder folder;
  // What the judge leaves behind in its folder for temporary files can be seen there.
  fs::create_directory(folder.path() / "work");
  fs::permissions(folder.path() / "work", fs::perms::owner_all | fs::perms::others_exec);
  ::setenv("TMPDIR", (folder.path() / "work").c_str(), 1);
  return ClassBench(options, folder.path()).run();
}

}  // namespace
}  // namespace tumble::bench

int main(int argc, char** argv) {
  using tumble::bench::Options;
  Options options;
  CLI::App app("Grading a class that is made up: time, and whether it changes any verdict.",
               "./tumble bench judge");
  app.add_option("--students", options.students, "how many")->check(CLI::Range(1, 9999));
  app.add_option("--seed", options.seed, "of the class and of its inputs");
  app.add_option("--alone", options.alone, "how many of them are also judged alone")
      ->check(CLI::Range(1, 9999));
  app.add_option("--units", options.units, "which exercises: 4.1, 4, all");
  bool quick = false, unbroken = false;
  app.add_flag("--quick", quick, "six students, a chapter: to see that everything works");
  app.add_flag("--unbroken", unbroken, "leave out the grading that is killed");
  return tumble::support::run_command_line(app, argc, argv, [&] {
    if (quick) options.students = 6, options.units = "4", options.alone = 2;
    options.killed_too = !unbroken;
    return tumble::bench::run(options) ? 0 : 1;
  });
}
