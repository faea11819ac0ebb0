#include "judge/build/worker_build.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "judge/build/confined_compiler.hpp"
#include "judge/build/diagnostics.hpp"
#include "judge/build/header_errors.hpp"
#include "judge/build/inspection.hpp"
#include "judge/build/link_failure.hpp"
#include "judge/build/object_cache.hpp"
#include "judge/build/submission.hpp"
#include "judge/course/contract.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

/// The steps from a source file to a worker, each a run of the compiler behind its walls.
class Builder {
 public:
  /// @param text of the source
  Builder(const Job& job, Instrumentation instrumentation, std::string text)
      : course_(job.course),
        unit_(job.unit),
        tools_(job.course.toolchain),
        sanitized_(instrumentation == Instrumentation::sanitizers),
        text_(std::move(text)),
        contracts_(contracts_of(job.course)),
        compiler_(job.course, job.folder, files_to_read(job.course, job.unit)) {}

  WorkerBuild build(const ObjectCache* cache) {
    WorkerBuild result = cache ? compiled_once(*cache) : compiled();
    if (result.outcome == BuildOutcome::built && link(result))
      result.worker = sanitized_ ? sanitized_worker() : confined_worker(folder(), worker());
    return result;
  }

  WorkerBuild compiled_once(const ObjectCache& cache) {
    if (std::optional<WorkerBuild> known = cache.find(unit_, text_, object())) {
      if (known->outcome == BuildOutcome::built) compiler_.hand_over({object()});
      return *known;
    }
    WorkerBuild result = compiled();
    cache.keep(unit_, text_, result);
    return result;
  }

  /// As far as the object; the first step that fails says what the outcome is.
  WorkerBuild compiled() {
    support::write_text(source(), text_);
    compiler_.hand_over({source()});
    WorkerBuild result;
    if (compile(result) && assemble(result)) result.object = object();
    return result;
  }

  /// gcc is silent about a variable that gets a mark.
  std::string words_without_marks() {
    support::write_text(source(), text_);
    compiler_.hand_over({source()});
    Arguments arguments = source_flags();
    const bool is_gcc = tools_.compiler_id == "GNU";
    if (is_gcc) std::erase(arguments, "-ftrivial-auto-var-init=pattern");
    arguments.insert(arguments.end(),
                     {is_gcc ? "-Wmaybe-uninitialized" : "-Wconditional-uninitialized", "-S",
                      source().string(), "-o", assembly().string()});
    return messages_about(source(), run(arguments).output, false);
  }

 private:
  static std::vector<fs::path> contracts_of(const Course& course) {
    std::vector<fs::path> contracts = {course.root / "exercises" / "not_implemented.hpp"};
    for (const Unit& each : course.units) contracts.push_back(course.contract(each));
    return contracts;
  }

  static std::vector<fs::path> files_to_read(const Course& course, const Unit& unit) {
    std::vector<fs::path> files = contracts_of(course);
    files.insert(files.end(), {course.toolchain.precompiled.parent_path(), course.toolchain.runtime,
                               unit.worker});
    files.insert(files.end(), unit.earlier.begin(), unit.earlier.end());
    return files;
  }

  /// @throws std::runtime_error if the step was ended by what is not the student's doing
  Finished run(const Arguments& arguments) const {
    Finished step = compiler_.run(arguments);
    const bool part_was_killed = step.ending != Ending{false, 0} &&
                                 says_that_it_was_killed(step.output) &&
                                 !has_error_in(source(), step.output);
    const std::string lowered = lowered_limits(compiler_limits());
    if (step.killed_from_outside || part_was_killed)
      throw std::runtime_error("the compiler was killed: " +
                               (lowered.empty() ? "the memory of this machine is used up?"
                                                : "this machine allows it only " + lowered));
    if (step.timed_out)
      throw std::runtime_error("the compiler did not get the processor: too much runs here");
    return step;
  }

  /// Files the outcome of a step of the compiler that did not succeed.
  bool succeeded(const Finished& step, WorkerBuild& result, bool others) const {
    if (step.ending == Ending{false, 0}) return true;
    result.explained = has_error_in(source(), step.output);
    // The text may be nowhere: an object that was kept is linked without it.
    const std::string output = header_errors_at(source(), text_, step.output);
    result.detail = messages_about(source(), output, others) + advice_on(output);
    if (result.detail.empty()) result.detail = "It ended without a word about a line of yours.\n";
    result.outcome =
        ran_into_limits(step) ? BuildOutcome::too_expensive : BuildOutcome::does_not_compile;
    return false;
  }

  /// Flags, headers and sanitizers: the same for every step that reads the source.
  Arguments source_flags() const {
    Arguments flags = tools_.flags;
    const fs::path exercises = course_.root / "exercises";
    for (const fs::path& folder : {exercises / unit_.chapter, exercises})
      flags.insert(flags.end(), {"-I", folder.string()});
    if (sanitized_)
      flags.insert(flags.end(), tools_.sanitizer_flags.begin(), tools_.sanitizer_flags.end());
    if (tools_.compiler_id == "GNU")  // finds the .gch beside it
      flags.insert(flags.end(), {"-Winvalid-pch", "-include",
                                 fs::path(precompiled()).replace_extension().string()});
    else
      flags.insert(flags.end(), {"-include-pch", precompiled().string()});
    flags.insert(flags.end(), {"-include", course_.contract(unit_).string()});
    return flags;
  }

  /// What a file includes that does not compile: before the compiler's words about it are passed
  /// on.
  bool preprocess(WorkerBuild& result) const {
    const fs::path rule = folder() / "included";
    Arguments arguments = source_flags();
    arguments.insert(arguments.end(), {"-E", "-MD", "-MF", rule.string(), source().string(), "-o",
                                       (folder() / "preprocessed").string()});
    const Finished step = run(arguments);
    if (step.output.find("Permission denied") != std::string::npos) {
      result.outcome = BuildOutcome::forbidden_include;
      result.detail = messages_about(source(), step.output, false);
      result.explained = false;  // it may be our own file that cannot be read here
      return false;
    }
    return succeeded(step, result, false) && sees_nothing_forbidden(rule, result);
  }

  /// @throws std::runtime_error if there is no list of what it includes, or of what it may include
  bool sees_nothing_forbidden(const fs::path& rule, WorkerBuild& result) const {
    const std::vector<fs::path> included = dependencies_of(rule);
    if (included.empty())
      throw std::runtime_error("the compiler wrote no list of what it read (is the disk full?)");
    const AllowedHeaders allowed(fs::path(tools_.precompiled.string() + ".d"), contracts_);
    for (const fs::path& file : included) {
      if (file == source() || allowed.contains(file) || file == precompiled()) continue;
      result.outcome = BuildOutcome::forbidden_include;
      result.detail = file.string();
      result.involves_course = true;
      return false;
    }
    return true;
  }

  bool compile(WorkerBuild& result) const {
    Arguments arguments = source_flags();
    const fs::path rule = folder() / "compiled";
    arguments.insert(arguments.end(), {"-S", "-MD", "-MF", rule.string(), source().string(), "-o",
                                       assembly().string()});
    const Finished step = run(arguments);
    const bool failed = step.ending != Ending{false, 0};
    if (failed && ran_into_limits(step)) {  // and so would the look at what it includes
      result.outcome = BuildOutcome::too_expensive;
      result.explained = false;
      return false;
    }
    if (failed && !preprocess(result)) return false;
    if (!succeeded(step, result, true) || !sees_nothing_forbidden(rule, result)) return false;
    result.warnings = messages_about(source(), step.output, false);
    if (line_with_assembler(assembly()) > 0 && !sanitized_) {
      result.outcome = BuildOutcome::assembly;
      return false;
    }
    return true;
  }

  bool assemble(WorkerBuild& result) const {
    return succeeded(run({"-c", assembly().string(), "-o", object().string()}), result, true);
  }

  Finished run_linker() const {
    // A student may define what the course provides too; where the linker can do it, the first
    // definition counts, and main is ours.
    Arguments arguments{unit_.worker.string(), object().string()};
    for (const auto* objects : {&unit_.earlier, &own_earlier_})
      for (const fs::path& earlier : *objects) arguments.push_back(earlier.string());
    arguments.insert(arguments.end(), {tools_.runtime.string(), "-o", worker().string()});
    for (const Arguments* flags : {&tools_.link, &tools_.link_first_counts})
      arguments.insert(arguments.end(), flags->begin(), flags->end());
    if (!tools_.linker.empty()) arguments.push_back("-fuse-ld=" + tools_.linker);
    // lld starts a thread for every core, which costs more than it saves.
    if (tools_.linker == "lld") arguments.emplace_back("-Wl,--threads=1");
    if (sanitized_) {
      arguments.emplace_back("-fsanitize=address,undefined");
    } else {  // without the names of lines, which nobody reads there
      arguments.insert(arguments.end(), tools_.link_confined.begin(), tools_.link_confined.end());
      arguments.emplace_back("-Wl,-S");
    }
    return run(arguments);
  }

  /// Where there are no solutions, the student's own functions of earlier units stand in for them.
  /// @return whether that may help
  bool add_own_earlier(const std::vector<std::string>& functions, WorkerBuild& result) {
    bool found = false;
    for (const Unit& earlier : course_.units) {
      const bool used =
          std::find(functions.begin(), functions.end(), earlier.function()) != functions.end();
      if (!used || earlier.id() == unit_.id() || !earlier.solution.empty()) continue;
      const std::string called = earlier.number + " " + earlier.name + ", which it calls, ";
      const fs::path source = course_.instead_of_solution(earlier);
      if (!fs::is_regular_file(source) ||
          decoded(support::read_text(source)).text == stub_of(course_, earlier)) {
        result.outcome = BuildOutcome::does_not_compile;
        result.detail = called + "is not written yet:  ./tumble check " + earlier.number + "\n";
        return false;
      }
      const WorkerBuild build = compile_unit({course_, earlier, source, folder() / earlier.name});
      if (build.outcome != BuildOutcome::built) {
        result.outcome = BuildOutcome::does_not_compile;
        result.explained = build.explained;
        result.involves_course = build.involves_course;
        result.detail =
            called + name_of(build.outcome) + ":  ./tumble check " + earlier.number + "\n";
        return false;
      }
      own_earlier_.push_back(build.object);
      found = true;
    }
    return found;
  }

  bool link(WorkerBuild& result) {
    Finished step = run_linker();
    while (step.ending != Ending{false, 0} &&
           add_own_earlier(undefined_functions(step.output), result))
      step = run_linker();
    if (result.outcome != BuildOutcome::built) return false;
    if (succeeded(step, result, true)) return true;
    if (result.outcome != BuildOutcome::does_not_compile) return false;
    explain_link_failure(result, course_, unit_, step.output, compiler_.functions_in(object()),
                         text_);
    return false;
  }

  /// Its shadow memory is terabytes, and it reads about itself in /proc.
  WorkerProgram sanitized_worker() const {
    WorkerProgram program = confined_worker(folder(), worker());
    Walls& walls = program.walls;
    walls.system_calls = CallRules::sanitizer;
    walls.limits.memory_bytes = ~0ull;
    walls.limits.cpu_seconds = 10;
    walls.files.read.insert(walls.files.read.end(),
                            {"/proc", "/usr", "/lib", "/lib64", "/etc/ld.so.cache"});
    program.environment = {
        "ASAN_OPTIONS=detect_leaks=0:handle_abort=1:handle_sigfpe=1:hard_rss_limit_mb=1024:"
        "malloc_fill_byte=254:max_malloc_fill_size=1048576:detect_stack_use_after_return=1",
        "UBSAN_OPTIONS=print_stacktrace=1"};
    return program;
  }

  const fs::path& precompiled() const {
    return sanitized_ ? tools_.precompiled_sanitized : tools_.precompiled;
  }
  const fs::path& folder() const { return compiler_.folder(); }
  fs::path source() const { return folder() / (unit_.name + ".cpp"); }
  fs::path assembly() const { return folder() / (unit_.name + ".s"); }
  fs::path object() const { return folder() / (unit_.name + ".o"); }
  fs::path worker() const { return folder() / "worker"; }

  const Course& course_;
  const Unit& unit_;
  const Toolchain& tools_;
  bool sanitized_;
  std::string text_;
  std::vector<fs::path> contracts_, own_earlier_;
  ConfinedCompiler compiler_;
};

/// Runs `step` on the text of a file, unless that is refused.
template <class Step>
WorkerBuild with_text_of(const fs::path& source, Step&& step) {
  try {
    return step(read_submission(source));
  } catch (const Refused& why) {
    WorkerBuild result;
    result.outcome = BuildOutcome::refused;
    result.detail = why.what();
    return result;
  }
}

/// A text for this unit that compiles wherever the machine can compile at all.
std::string known_to_compile(const Course& course, const Unit& unit) {
  const fs::path solution = course.solution(unit);
  return fs::exists(solution) ? support::read_text(solution) : stub_of(course, unit);
}

/// How the course's own file for a unit is built here.
WorkerBuild build_known(const Job& job, Instrumentation instrumentation) {
  const Job known{job.course, job.unit, job.source, job.folder / "known"};
  return Builder(known, instrumentation, known_to_compile(job.course, job.unit)).build(nullptr);
}

/// A build that failed, and not for sure by the student's file: would one of ours succeed?
/// @throws std::runtime_error if not: it is this machine that cannot build
void require_machine_builds(const Job& job, Instrumentation instrumentation) {
  const bool sanitized = instrumentation == Instrumentation::sanitizers;
  WorkerBuild known = build_known(job, instrumentation);
  if (known.outcome == BuildOutcome::built) return;
  if (sanitized) {  // are they all that is missing?
    known = build_known(job, Instrumentation::none);
    if (known.outcome == BuildOutcome::built) throw NoSanitizers();
  }
  throw std::runtime_error("this machine cannot build now: the course's own file for " +
                           job.unit.number + " is “" + name_of(known.outcome) + "” too" +
                           " (is the disk full, the memory used up, the compiler gone?) " +
                           known.detail.substr(0, 300));
}

/// How often a failure has to come again, a build of ours in between succeeding, before it is the
/// student's: a disk that is full now may have room a moment later. What may not be read does not
/// change so soon.
int repeats_before_blame(const WorkerBuild& build) {
  if (build.is_certain()) return 0;
  const bool lasts = build.explained || build.outcome == BuildOutcome::too_expensive ||
                     build.outcome == BuildOutcome::forbidden_include;
  return lasts ? 1 : 3;
}

/// The build, with a failure that is the student's for sure.
/// @throws std::runtime_error if it is, or may be, this machine's
WorkerBuild build_for_sure(const Job& job, Instrumentation instrumentation,
                           const ObjectCache* compiled, const std::string& text) {
  WorkerBuild result = Builder(job, instrumentation, text).build(compiled);
  for (int left = repeats_before_blame(result); left > 0 && !result.is_certain(); --left) {
    require_machine_builds(job, instrumentation);
    result = Builder(job, instrumentation, text).build(compiled);
  }
  if (const std::string lowered = lowered_limits(compiler_limits());
      !result.explained && !lowered.empty())
    throw std::runtime_error("the compiler failed, and this machine allows it only " + lowered);
  return result;
}

}  // namespace

WorkerBuild build_worker(const Job& job, Instrumentation instrumentation,
                         const ObjectCache* compiled) {
  return with_text_of(job.source, [&](const std::string& text) {
    return build_for_sure(job, instrumentation, compiled, text);
  });
}

std::string words_about_unset(const Job& job) {
  try {
    return Builder(job, Instrumentation::none, read_submission(job.source)).words_without_marks();
  } catch (const std::runtime_error&) {  // the verdict is known already
    return {};
  }
}

WorkerBuild compile_unit(const Job& job, const ObjectCache* compiled) {
  return with_text_of(job.source, [&](const std::string& text) {
    Builder builder(job, Instrumentation::none, text);
    return compiled ? builder.compiled_once(*compiled) : builder.compiled();
  });
}

}  // namespace tumble::judge
