#include "judge/build/worker_build.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "judge/build/diagnostics.hpp"
#include "judge/build/inspection.hpp"
#include "judge/build/submission.hpp"
#include "judge/course/contract.hpp"

namespace tumble::judge {

namespace {

using Arguments = std::vector<std::string>;

/// The steps from a source file to a worker, each a run of the compiler behind its walls.
class Builder {
 public:
  Builder(const Course& course, const Unit& unit, fs::path folder, Instrumentation instrumentation)
      : course_(course),
        unit_(unit),
        tools_(course.toolchain),
        folder_(std::move(folder)),
        sanitized_(instrumentation == Instrumentation::sanitizers) {
    source_ = folder_ / (unit.name + ".cpp");
    contracts_ = {course.root / "exercises" / "not_implemented.hpp"};
    for (const Unit& each : course.units) contracts_.push_back(course.contract(each));
    confine_compiler();
  }

  WorkerBuild build(const std::string& text) {
    std::ofstream(source_) << text;
    hand_over();
    WorkerBuild result;
    // The first step that fails says what the outcome is.
    static_cast<void>(preprocess(result) && compile(result) && assemble(result) && link(result));
    if (result.outcome == BuildOutcome::built) result.worker = confined_worker();
    return result;
  }

 private:
  void confine_compiler() {
    fs::create_directories(folder_);
    confinement_.folder = folder_;
    confinement_.limits = {.cpu_seconds = 10,
                           .wall_seconds = 40,
                           .memory_bytes = 4ull << 30,
                           .file_bytes = 256ull << 20,
                           .processes = 64};
    confinement_.other_user = others_may_compile(course_);
    confinement_.files.write = {folder_, "/dev/null"};
    auto& read = confinement_.files.read;
    read = {"/usr",
            "/lib",
            "/lib32",
            "/lib64",
            "/bin",
            "/etc/alternatives",
            "/etc/ld.so.cache",
            "/proc/cpuinfo",
            "/proc/meminfo"};
    // A compiler and an Eigen that live elsewhere.
    read.push_back(fs::canonical(tools_.compiler).parent_path().parent_path());
    for (std::size_t i = 0; i + 1 < tools_.flags.size(); ++i)
      if (tools_.flags[i] == "-isystem") read.emplace_back(tools_.flags[i + 1]);
    read.push_back(tools_.precompiled.parent_path());
    read.push_back(tools_.runtime);
    read.push_back(unit_.worker);
    read.insert(read.end(), unit_.earlier.begin(), unit_.earlier.end());
    read.insert(read.end(), contracts_.begin(), contracts_.end());
  }

  /// The folder belongs to the user that the compiler runs as.
  void hand_over() const {
    if (geteuid() != 0 || !confinement_.other_user) return;
    for (const fs::path& path : {folder_, source_})
      if (chown(path.c_str(), unprivileged_id, unprivileged_id) != 0)
        throw std::runtime_error("cannot hand " + path.string() + " to the compiler's user");
  }

  Finished run(const Arguments& arguments) const {
    Arguments command{tools_.compiler};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_confined(
        command, {"PATH=/usr/local/bin:/usr/bin:/bin", "LC_ALL=C", "TMPDIR=" + folder_.string()},
        confinement_);
  }

  /// Files the outcome of a step of the compiler that did not succeed.
  bool succeeded(const Finished& step, WorkerBuild& result, bool others) const {
    if (step.ending == Ending{false, 0}) return true;
    result.detail = messages_about(source_, step.output, others);
    const bool out_of_memory = step.output.find("out of memory") != std::string::npos ||
                               step.output.find("cannot allocate") != std::string::npos ||
                               step.output.find("memory exhausted") != std::string::npos;
    const bool stopped = step.timed_out || step.ending.by_signal || out_of_memory ||
                         step.output.find("Killed") != std::string::npos ||
                         step.output.find("CPU time limit") != std::string::npos ||
                         step.output.find("File size limit") != std::string::npos;
    result.outcome = stopped ? BuildOutcome::too_expensive : BuildOutcome::does_not_compile;
    return false;
  }

  /// Flags, headers and sanitizers: the same for every step that reads the source.
  Arguments source_flags() const {
    Arguments flags = tools_.flags;
    const fs::path exercises = course_.root / "exercises";
    for (const fs::path& folder : {exercises / unit_.chapter, exercises})
      flags.insert(flags.end(), {"-I", folder.string()});
    if (sanitized_)
      flags.insert(flags.end(), {"-fsanitize=address,undefined", "-fno-sanitize-recover=undefined",
                                 "-fno-omit-frame-pointer"});
    else if (tools_.compiler_id == "GNU")  // finds the .gch beside it
      flags.insert(flags.end(), {"-Winvalid-pch", "-include",
                                 fs::path(tools_.precompiled).replace_extension().string()});
    else
      flags.insert(flags.end(), {"-include-pch", tools_.precompiled.string()});
    flags.insert(flags.end(), {"-include", course_.contract(unit_).string()});
    return flags;
  }

  bool preprocess(WorkerBuild& result) const {
    const fs::path rule = folder_ / "included";
    Arguments arguments = source_flags();
    arguments.insert(arguments.end(), {"-E", "-MD", "-MF", rule.string(), source_.string(), "-o",
                                       (folder_ / "preprocessed").string()});
    const Finished step = run(arguments);
    if (step.output.find("Permission denied") != std::string::npos) {
      result.outcome = BuildOutcome::forbidden_include;
      result.detail = messages_about(source_, step.output, false);
      return false;
    }
    return succeeded(step, result, false) && sees_nothing_forbidden(rule, result);
  }

  bool sees_nothing_forbidden(const fs::path& rule, WorkerBuild& result) const {
    const AllowedHeaders allowed(fs::path(tools_.precompiled.string() + ".d"), contracts_);
    for (const fs::path& file : dependencies_of(rule)) {
      if (file == source_ || allowed.contains(file) || file == tools_.precompiled) continue;
      result.outcome = BuildOutcome::forbidden_include;
      result.detail = file.string();
      return false;
    }
    return true;
  }

  bool compile(WorkerBuild& result) const {
    Arguments arguments = source_flags();
    // The source is read a second time, and may ask (__has_include) what has changed since the
    // first.
    const fs::path rule = folder_ / "compiled";
    arguments.insert(arguments.end(), {"-S", "-MD", "-MF", rule.string(), source_.string(), "-o",
                                       assembly().string()});
    const Finished step = run(arguments);
    if (!succeeded(step, result, true) || !sees_nothing_forbidden(rule, result)) return false;
    result.warnings = messages_about(source_, step.output, false);
    if (line_with_assembler(assembly()) > 0 && !sanitized_) {
      result.outcome = BuildOutcome::assembly;
      return false;
    }
    return true;
  }

  bool assemble(WorkerBuild& result) const {
    return succeeded(run({"-c", assembly().string(), "-o", object().string()}), result, true);
  }

  bool link(WorkerBuild& result) const {
    // A student may define what the course provides too; the first definition counts, and main is
    // ours.
    Arguments arguments{unit_.worker.string(), object().string()};
    for (const fs::path& earlier : unit_.earlier) arguments.push_back(earlier.string());
    arguments.insert(arguments.end(), {tools_.runtime.string(), "-Wl,-z,muldefs", "-no-pie", "-o",
                                       worker().string()});
    if (!tools_.linker.empty()) arguments.push_back("-fuse-ld=" + tools_.linker);
    arguments.emplace_back(sanitized_ ? "-fsanitize=address,undefined" : "-static");
    const Finished step = run(arguments);
    if (succeeded(step, result, true)) return true;
    if (result.outcome != BuildOutcome::does_not_compile) return false;
    const std::vector<std::string> undefined = undefined_functions(step.output);
    const bool absent = std::any_of(undefined.begin(), undefined.end(), [&](const auto& name) {
      return name.ends_with("::" + unit_.name);
    });
    if (absent) {
      result.outcome = BuildOutcome::wrong_signature;
      result.detail = read_declaration(course_, unit_).signature;
    } else if (!undefined.empty()) {
      result.detail = "These functions are used, and are not there:\n";
      for (const std::string& name : undefined) result.detail += "  " + name + "\n";
      const bool of_eigen = undefined.front().find("Eigen::") != std::string::npos;
      result.detail += of_eigen ? "(Eigen/Core is all of Eigen that an exercise has.)\n"
                                : "(A later unit? A helper that is declared, but not defined?)\n";
    } else {
      result.detail = "linking fails:\n" + step.output;  // names of functions, no text of a file
    }
    return false;
  }

  WorkerProgram confined_worker() const {
    fs::permissions(folder_, fs::perms::owner_all | fs::perms::others_exec | fs::perms::group_exec);
    fs::permissions(worker(), fs::perms::owner_all | fs::perms::others_read |
                                  fs::perms::others_exec | fs::perms::group_exec);
    const fs::path empty = folder_ / "empty";
    fs::create_directory(empty);
    fs::permissions(empty, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_exec);
    Confinement confinement;
    confinement.folder = empty;
    confinement.files.read = {worker()};
    confinement.system_calls = CallRules::worker;
    Arguments environment;
    if (sanitized_) {  // its shadow memory is terabytes, and it reads about itself in /proc
      confinement.system_calls = CallRules::sanitizer;
      confinement.limits.memory_bytes = ~0ull;
      confinement.limits.cpu_seconds = 10;
      confinement.files.read.insert(confinement.files.read.end(),
                                    {"/proc", "/usr", "/lib", "/lib64", "/etc/ld.so.cache"});
      environment = {
          "ASAN_OPTIONS=detect_leaks=0:handle_abort=1:handle_sigfpe=1:hard_rss_limit_mb=1024",
          "UBSAN_OPTIONS=print_stacktrace=1"};
    }
    return {worker(), confinement, environment};
  }

  fs::path assembly() const { return folder_ / (unit_.name + ".s"); }
  fs::path object() const { return folder_ / (unit_.name + ".o"); }
  fs::path worker() const { return folder_ / "worker"; }

  const Course& course_;
  const Unit& unit_;
  const Toolchain& tools_;
  fs::path folder_, source_;
  bool sanitized_;
  std::vector<fs::path> contracts_;
  Confinement confinement_;
};

}  // namespace

std::string name_of(BuildOutcome outcome) {
  switch (outcome) {
    case BuildOutcome::built:
      return "built";
    case BuildOutcome::refused:
      return "refused";
    case BuildOutcome::does_not_compile:
      return "does not compile";
    case BuildOutcome::forbidden_include:
      return "forbidden include";
    case BuildOutcome::assembly:
      return "assembly";
    case BuildOutcome::too_expensive:
      return "too expensive to compile";
    case BuildOutcome::wrong_signature:
      return "wrong signature";
  }
  return "unknown";
}

bool others_may_compile(const Course& course) {
  return others_may_enter(course.toolchain.precompiled.parent_path()) &&
         others_may_enter(course.root / "exercises");
}

WorkerBuild build_worker(const Course& course, const Unit& unit, const fs::path& source,
                         const fs::path& folder, Instrumentation instrumentation) {
  try {
    return Builder(course, unit, folder, instrumentation).build(read_submission(source));
  } catch (const Refused& why) {
    WorkerBuild result;
    result.outcome = BuildOutcome::refused;
    result.detail = why.what();
    return result;
  }
}

}  // namespace tumble::judge
