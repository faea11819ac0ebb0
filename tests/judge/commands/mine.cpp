#include "judge/mine/measure.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include "judge/build/object_cache.hpp"
#include "judge/build/work_folder.hpp"
#include "judge/commands/given_files.hpp"
#include "judge/commands/mine_module.hpp"
#include "judge/commands/sandbox.hpp"
#include "judge/mine/diagnosis.hpp"
#include "judge/mine/engine_build.hpp"
#include "judge/mine/report.hpp"
#include "judge/mine/travelling_curve.hpp"
#include "judge/verdict/console.hpp"
#include "judge/verdict/judge_all.hpp"
#include "judge/verdict/number_text.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

void progress(const std::string& what) { std::cerr << "tumble: " << what << "\n"; }

/// Those of the student's functions that do not pass their own specs.
std::vector<UnitResult> failing_units(const Course& course, const mine::EngineBuild& build) {
  std::vector<Unit> units;
  std::vector<fs::path> sources;
  for (const mine::Part& part : build.parts)
    if (part.own()) units.push_back(part.unit), sources.push_back(part.source);
  const auto source_of = [&](const Unit& unit) {
    const auto same = [&](const Unit& each) { return each.id() == unit.id(); };
    return sources[static_cast<std::size_t>(std::find_if(units.begin(), units.end(), same) -
                                            units.begin())];
  };
  Judgement judgement;
  judgement.locate_crashes = false;  // `check` does, when it is asked for one of them
  const std::unique_ptr<const ObjectCache> earlier = objects_of_earlier(course);
  judgement.compiled = earlier.get();
  std::vector<UnitResult> failing;
  judge_all(course, units, source_of, judgement, [&](const UnitResult& result) {
    if (!result.passed()) failing.push_back(result);
  });
  return failing;
}

void explain(const Course& course, const mine::EngineBuild& build,
             const std::vector<std::string>& findings) {
  std::cout << "\nWhat is wrong:\n";
  for (const std::string& finding : findings)
    std::cout << "  ✗ " << one_line(finding, 2000) << "\n";
  progress("the judge checks each of your functions, to find the cause");
  const std::vector<UnitResult> failing = failing_units(course, build);
  if (failing.empty())
    std::cout << "\n  Each of your functions passes its own laws. Try others:  ./tumble check all "
                 "--seeds 20\n";
  else
    std::cout << "\n  Of your functions, these do not pass:\n";
  for (const UnitResult& result : failing) {
    std::cout << "  ";
    print_line(std::cout, result, style_of_terminal());
  }
  if (!failing.empty())
    std::cout << "  Next:  ./tumble check " << failing.front().unit.number << "\n";
}

/// Where the figure goes: if not said, where ./tumble builds.
fs::path figure_file(const Course& course, const MineOptions& options) {
  if (options.svg) return *options.svg;
  const char* elsewhere = std::getenv("TUMBLE_BUILD");
  const fs::path builds = elsewhere && *elsewhere ? elsewhere : course.root / "build";
  fs::create_directories(builds);
  return builds / "mine.svg";
}

/// What runs: an engine, and a die where what it takes is there.
struct Engines {
  mine::EngineBuild build;  ///< with the parts of both
  std::optional<WorkerProgram> die = {};
  std::vector<mine::Part> waiting = {};  ///< what the die lacks
  std::string die_does_not_link = {};    ///< what the linker misses, if it does
};

void add_die(Engines& engines, const mine::EngineBuild& die, bool fill) {
  if (!fill) engines.waiting = die.missing();
  if (!engines.waiting.empty()) return;
  engines.die_does_not_link = die.does_not_link;
  if (!die.does_not_link.empty()) return;
  engines.build.add(die);
  engines.die = die.worker;
}

mine::Measurement measurement_of(const Engines& engines) {
  mine::Measurement measurement = mine::measure(mine::OwnEngine(engines.build.worker), progress);
  if (!engines.die) return measurement;
  progress("a die that falls onto a table");
  measurement.die = mine::die_of(*engines.die);
  return measurement;
}

int measured(const Course& course, const MineOptions& options, const Engines& engines) {
  const mine::EngineBuild& build = engines.build;
  mine::print_parts(std::cout, build);
  const mine::Measurement measurement = measurement_of(engines);
  std::vector<std::string> findings = mine::diagnose(measurement);
  if (!engines.die_does_not_link.empty())
    findings.push_back("The die: your functions of chapter 11 use what is not there: " +
                       engines.die_does_not_link);
  const fs::path svg = figure_file(course, options);
  support::write_text(svg, mine::figure_of(build, measurement));
  if (options.json)
    support::write_text(*options.json,
                        mine::json_of(build, &measurement, engines.waiting, findings));
  mine::print_measurement(std::cout, build, measurement);
  if (!engines.waiting.empty()) mine::print_waiting(std::cout, course, engines.waiting);
  if (!findings.empty()) explain(course, build, findings);
  std::cout << "\n"
            << (findings.empty() ? "Every curve falls as its method promises. " : "")
            << "The figure: " << svg.string() << "\n";
  return findings.empty() ? 0 : 1;
}

int not_built(const MineOptions& options, const mine::EngineBuild& build,
              const std::string& finding) {
  if (options.json)
    support::write_text(*options.json, mine::json_of(build, nullptr, {}, {finding}));
  return 1;
}

int run_mine(const Course& course, const MineOptions& options) {
  if (!may_judge(course, options.strict ? Strangers::strictly : Strangers::no)) return 2;
  if (options.fill && !course.has_solutions()) {
    std::cerr << "tumble: --fill: this tree has no solutions, it was handed out without them\n";
    return 2;
  }
  std::optional<GivenFiles> given;
  if (options.from) given.emplace(course, *options.from);
  const WorkFolder work;
  progress("compiling the functions that an engine needs");
  mine::EngineBuilder builder(
      course, [&](const Unit& unit) { return given ? given->of(unit) : course.exercise(unit); },
      work.path());
  Engines engines{builder.build(course.engine)};
  const mine::EngineBuild& build = engines.build;
  if (const std::vector<mine::Part> missing = build.missing(); !missing.empty() && !options.fill) {
    mine::print_missing(std::cout, course, build);
    return not_built(options, build, "missing: " + mine::names_of(missing));
  }
  if (!build.does_not_link.empty()) {
    std::cout << "Your functions use these names, and no file defines them:\n\n"
              << printable(build.does_not_link)
              << "\nDid you declare a helper and not define it? To find the file:  ./tumble check "
                 "all\n";
    return not_built(options, build, "does not link: " + build.does_not_link);
  }
  add_die(engines, builder.build(course.die), options.fill);
  return measured(course, options, engines);
}

}  // namespace

extern "C" const MineModule tumble_mine_module = {run_mine, mine::travelling_curve};

}  // namespace tumble::judge
