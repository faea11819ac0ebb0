#include "judge/commands/sandbox.hpp"

#include <algorithm>
#include <iostream>

#include "judge/build/confined_compiler.hpp"
#include "judge/commands/commands.hpp"

namespace tumble::judge {

std::vector<MissingWall> missing_walls(const Course& course) {
  std::vector<MissingWall> missing = missing_walls();
  const bool one_user = std::any_of(missing.begin(), missing.end(), [](const MissingWall& each) {
    return each.wall == Wall::other_user;
  });
  if (!one_user && !others_may_compile(course))
    missing.push_back({Wall::other_user, "other users may not enter " + course.root.string() +
                                             ", so the compiler runs as root"});
  if (!one_user && !others_may_enter(fs::temp_directory_path()))
    missing.push_back({Wall::other_user, "other users may not enter " +
                                             fs::temp_directory_path().string() +
                                             ", so students' code runs as root"});
  return missing;
}

bool may_judge(const Course& course, Strangers strangers) {
  const std::vector<MissingWall> missing = missing_walls(course);
  for (const MissingWall& each : missing)
    if (strangers != Strangers::no || each.wall != Wall::other_user)
      std::cerr << "tumble: the sandbox lacks " << name_of(each.wall) << ": " << each.why << "\n";
  for (const MissingWall& each : missing)
    if (each.wall == Wall::limits) {
      std::cerr << "tumble: nothing can be judged here, as no process can be confined\n";
      return false;
    }
  if (missing.empty() || strangers != Strangers::strictly) return true;
  std::cerr << "tumble: --strict: nothing is judged\n";
  return false;
}

int sandbox(const Course& course) {
  const std::vector<MissingWall> missing = missing_walls(course);
  for (const Wall wall : {Wall::limits, Wall::other_user, Wall::files, Wall::system_calls}) {
    std::string why;
    for (const MissingWall& each : missing)
      if (each.wall == wall) why = each.why;
    std::cout << (why.empty() ? "stands   " : "missing  ") << name_of(wall)
              << (why.empty() ? "" : ": " + why) << "\n";
  }
  return missing.empty() ? 0 : 1;
}

}  // namespace tumble::judge
