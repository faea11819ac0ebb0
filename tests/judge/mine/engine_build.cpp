#include "judge/mine/engine_build.hpp"

#include <algorithm>
#include <future>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <utility>

#include "judge/build/confined_compiler.hpp"
#include "judge/build/diagnostics.hpp"
#include "judge/build/object_cache.hpp"
#include "judge/build/worker_build.hpp"
#include "judge/course/contract.hpp"
#include "judge/mine/compiled_part.hpp"

namespace tumble::judge::mine {

/// The objects so far, and the linker that says what they lack.
class EngineBuilder::Linker {
 public:
  Linker(const Course& course, SourceOf source, fs::path folder)
      : course_(course), source_(std::move(source)), folder_(std::move(folder)) {}

  EngineBuild build(const fs::path& questions) {
    questions_ = questions;
    linked_.clear();
    EngineBuild result;
    Finished step = link(Twice::first_counts);
    while (failed(step) && add(undefined_functions(step.output))) step = link(Twice::first_counts);
    if (failed(step))
      result.does_not_link = text_of(undefined_functions(step.output), step.output);
    else if (const Finished strict = link(Twice::refused); failed(strict)) {
      result.defined_twice = duplicate_functions(strict.output);
      link(Twice::first_counts);
    }
    if (!failed(step)) result.worker = confined_worker(linked_in(), worker());
    for (const std::size_t place : linked_) result.parts.push_back(compiled_.at(place).part);
    return result;
  }

 private:
  fs::path linked_in() const { return folder_ / questions_.stem(); }
  fs::path worker() const { return linked_in() / "worker"; }
  fs::path folder_of(const Unit& unit) const { return folder_ / (unit.chapter + "-" + unit.name); }

  static bool failed(const Finished& step) { return step.ending != Ending{false, 0}; }

  /// What becomes of a function that two files define.
  enum class Twice { refused, first_counts };

  Finished link(Twice twice) const {
    const Toolchain& tools = course_.toolchain;
    std::vector<fs::path> objects{questions_};
    for (const std::size_t place : linked_)
      if (const fs::path& object = compiled_.at(place).object; !object.empty())
        objects.push_back(object);
    objects.push_back(tools.runtime);
    Arguments arguments(objects.begin(), objects.end());
    arguments.insert(arguments.end(), {"-o", worker().string()});
    const Arguments none;
    for (const Arguments* flags : {&tools.link, &tools.link_confined,
                                   twice == Twice::first_counts ? &tools.link_first_counts : &none})
      arguments.insert(arguments.end(), flags->begin(), flags->end());
    if (!tools.linker.empty()) arguments.push_back("-fuse-ld=" + tools.linker);
    if (tools.linker == "lld") arguments.emplace_back("-Wl,--error-limit=0");
    const ConfinedCompiler compiler(course_, linked_in(), objects);
    compiler.hand_over({});
    return compiler.run(arguments);
  }

  /// Adds the units of these functions.
  /// @return whether that may help
  bool add(const std::vector<std::string>& functions) {
    std::vector<std::size_t> places;
    bool helps = false;
    for (const std::string& function : functions)
      for (std::size_t i = 0; i < course_.units.size(); ++i) {
        if (course_.units[i].function() != function) continue;
        if (linked_.insert(i).second) {
          if (!compiled_.contains(i)) places.push_back(i);
          helps = true;
        } else if (Compiled& known = compiled_.at(i); known.part.own()) {
          // Its file defines something else.
          known.part.detail = read_declaration(course_, course_.units[i]).signature;
          take_solution(course_, known, name_of(BuildOutcome::wrong_signature),
                        folder_of(course_.units[i]));
          helps = true;
        }
      }
    compile_all(places);
    return helps;
  }

  void compile_all(const std::vector<std::size_t>& places) {
    const std::size_t at_once = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t done = 0; done < places.size(); done += at_once) {
      std::vector<std::pair<std::size_t, std::future<Compiled>>> running;
      for (std::size_t k = done; k < std::min(done + at_once, places.size()); ++k)
        running.emplace_back(places[k], std::async(std::launch::async, [&, i = places[k]] {
                               const Unit& unit = course_.units[i];
                               return compile(course_, {unit, source_(unit), {}, {}},
                                              folder_of(unit), earlier_.get());
                             }));
      for (auto& [place, future] : running) compiled_.emplace(place, future.get());
    }
  }

  static std::string text_of(const std::vector<std::string>& undefined, const std::string& output) {
    if (undefined.empty()) return output;
    std::string text;
    for (const std::string& name : undefined) text += name + "\n";
    return text;
  }

  const Course& course_;
  SourceOf source_;
  fs::path folder_;
  fs::path questions_;
  std::unique_ptr<const ObjectCache> earlier_ = objects_of_earlier(course_);
  std::map<std::size_t, Compiled> compiled_;  ///< by their place in the course
  std::set<std::size_t> linked_;              ///< those of them that this engine takes
};

std::vector<Part> EngineBuild::missing() const {
  std::vector<Part> list;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(list),
               [](const Part& part) { return !part.own(); });
  return list;
}

void EngineBuild::add(const EngineBuild& other) {
  const auto add_new = [](auto& all, const auto& more, auto same) {
    for (const auto& each : more)
      if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return same(one, each); }))
        all.push_back(each);
  };
  add_new(parts, other.parts,
          [](const Part& a, const Part& b) { return a.unit.id() == b.unit.id(); });
  add_new(defined_twice, other.defined_twice, std::equal_to<>());
}

EngineBuilder::EngineBuilder(const Course& course, SourceOf source, fs::path folder)
    : linker_(std::make_unique<Linker>(course, std::move(source), std::move(folder))) {}

EngineBuilder::~EngineBuilder() = default;

EngineBuild EngineBuilder::build(const fs::path& questions) { return linker_->build(questions); }

}  // namespace tumble::judge::mine
