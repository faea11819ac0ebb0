#include "judge/mine/engine_build.hpp"

#include <algorithm>
#include <future>
#include <map>
#include <thread>
#include <utility>

#include "judge/build/confined_compiler.hpp"
#include "judge/build/diagnostics.hpp"
#include "judge/build/worker_build.hpp"
#include "judge/course/contract.hpp"
#include "support/text_file.hpp"

namespace tumble::judge::mine {

namespace {

/// A part and its object.
struct Compiled {
  Part part;
  fs::path object;  ///< empty if there is none, not even the solution's
};

/// Whether a line of the file that is no comment throws what a stub throws.
bool throws_not_implemented(const std::string& text) {
  for (auto at = text.find("NotImplemented{"); at != std::string::npos;
       at = text.find("NotImplemented{", at + 1)) {
    const auto line = text.rfind('\n', at) + 1;
    if (text.substr(line, at - line).find("//") == std::string::npos) return true;
  }
  return false;
}

/// What can be said of a file without compiling it; empty if it has to be.
std::string not_written(const Course& course, const Part& part) {
  if (!fs::exists(fs::symlink_status(part.source))) return "there is no file";
  if (!fs::is_regular_file(fs::symlink_status(part.source))) return "is not a file";
  if (fs::file_size(part.source) > (1 << 20)) return {};  // refused, with its reason, when compiled
  const std::string text = support::read_text(part.source);
  if (text == stub_of(course, part.unit)) return "nothing is written yet";
  return throws_not_implemented(text) ? "still throws NotImplemented" : "";
}

/// Puts the solution in a part's place.
/// @param folder for what is built, where the course has solutions as sources only
void take_solution(const Course& course, Compiled& part, const std::string& why,
                   const fs::path& folder) {
  part.part.missing = why;
  part.object = part.part.unit.solution;
  const fs::path source = course.instead_of_solution(part.part.unit);
  if (part.object.empty() && source != part.part.source && fs::exists(source))
    part.object = compile_unit({course, part.part.unit, source, folder / "solution"}).object;
}

Compiled compile(const Course& course, Part part, const fs::path& folder) {
  Compiled result{std::move(part), {}};
  if (const std::string why = not_written(course, result.part); !why.empty()) {
    take_solution(course, result, why, folder);
    return result;
  }
  const WorkerBuild build = compile_unit({course, result.part.unit, result.part.source, folder});
  result.object = build.object;
  if (build.outcome == BuildOutcome::built) return result;
  result.part.detail = build.detail;
  take_solution(course, result, name_of(build.outcome), folder);
  return result;
}

/// The objects so far, and the linker that says what they lack.
class Linker {
 public:
  Linker(const Course& course, std::function<fs::path(const Unit&)> source, fs::path folder)
      : course_(course), source_(std::move(source)), folder_(std::move(folder)) {}

  EngineBuild build() {
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
    for (const auto& [place, compiled] : compiled_) result.parts.push_back(compiled.part);
    return result;
  }

 private:
  fs::path linked_in() const { return folder_ / "engine"; }
  fs::path worker() const { return linked_in() / "worker"; }
  fs::path folder_of(const Unit& unit) const { return folder_ / (unit.chapter + "-" + unit.name); }

  static bool failed(const Finished& step) { return step.ending != Ending{false, 0}; }

  /// What becomes of a function that two files define.
  enum class Twice { refused, first_counts };

  Finished link(Twice twice) const {
    const Toolchain& tools = course_.toolchain;
    std::vector<fs::path> objects{course_.engine};
    for (const auto& [place, compiled] : compiled_)
      if (!compiled.object.empty()) objects.push_back(compiled.object);
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
        const auto known = compiled_.find(i);
        if (known == compiled_.end()) {
          places.push_back(i);
        } else if (known->second.part.own()) {  // its file defines something else
          known->second.part.detail = read_declaration(course_, course_.units[i]).signature;
          take_solution(course_, known->second, name_of(BuildOutcome::wrong_signature),
                        folder_of(course_.units[i]));
          helps = true;
        }
      }
    compile_all(places);
    return helps || !places.empty();
  }

  void compile_all(const std::vector<std::size_t>& places) {
    const std::size_t at_once = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t done = 0; done < places.size(); done += at_once) {
      std::vector<std::pair<std::size_t, std::future<Compiled>>> running;
      for (std::size_t k = done; k < std::min(done + at_once, places.size()); ++k)
        running.emplace_back(
            places[k], std::async(std::launch::async, [&, i = places[k]] {
              const Unit& unit = course_.units[i];
              return compile(course_, {unit, source_(unit), {}, {}}, folder_of(unit));
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
  std::function<fs::path(const Unit&)> source_;
  fs::path folder_;
  std::map<std::size_t, Compiled> compiled_;  ///< by their place in the course
};

}  // namespace

std::vector<Part> EngineBuild::missing() const {
  std::vector<Part> list;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(list),
               [](const Part& part) { return !part.own(); });
  return list;
}

EngineBuild build_engine(const Course& course, const std::function<fs::path(const Unit&)>& source,
                         const fs::path& folder) {
  return Linker(course, source, folder).build();
}

}  // namespace tumble::judge::mine
