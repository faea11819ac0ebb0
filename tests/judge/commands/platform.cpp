#include "judge/platforms/platform.hpp"

#include <iostream>
#include <random>

#include "judge/build/work_folder.hpp"
#include "judge/class/grade_student.hpp"
#include "judge/commands/commands.hpp"
#include "judge/commands/sandbox.hpp"
#include "judge/course/text_file.hpp"

namespace tumble::judge {

int platform_command(const Course& course, const PlatformOptions& options) {
  const CourseSettings settings = settings_or_default(course, options.settings);
  const PlatformRun run = platform_run(options.platform, options.root, settings);
  if (!may_judge(course, Strangers::yes)) return 2;
  fs::create_directories(run.results.parent_path());
  write_text(run.results, run.text({}, ""));  // valid from the beginning
  const WorkFolder work;
  const ObjectCache compiled(work.path());
  const Grading grading{course, settings, settings.seed.value_or(std::random_device{}()),
                        judge_fingerprint(), compiled};
  StudentRecord record;
  grade_student(grading, {run.identity, run.submission, false}, work.path() / "record.json",
                [&](const StudentRecord& now) {
                  record = now;
                  write_text(run.results, run.text(now, ""));
                });
  for (const UnitRecord& unit : record.units) std::cout << unit.explanation << "\n";
  std::cout << earned(settings, record) << " of " << settings.most() << " points\n";
  return 0;
}

}  // namespace tumble::judge
