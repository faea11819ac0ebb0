#include "judge/commands/sandbox.hpp"

#include <algorithm>
#include <iostream>

#include "judge/build/confined_compiler.hpp"
#include "judge/commands/commands.hpp"

namespace tumble::judge {

std::vector<MissingLayer> missing_walls(const Course& course) {
  std::vector<MissingLayer> missing = missing_layers();
  const bool one_user = std::any_of(missing.begin(), missing.end(), [](const MissingLayer& each) {
    return each.layer == Layer::other_user;
  });
  if (!one_user && !others_may_compile(course))
    missing.push_back({Layer::other_user, "other users may not enter " + course.root.string() +
                                              ", so the compiler runs as root"});
  return missing;
}

bool may_judge(const Course& course, Strangers strangers) {
  const std::vector<MissingLayer> missing = missing_walls(course);
  for (const MissingLayer& each : missing)
    if (strangers != Strangers::no || each.layer != Layer::other_user)
      std::cerr << "tumble: the sandbox lacks " << name_of(each.layer) << ": " << each.why << "\n";
  if (missing.empty() || strangers != Strangers::strictly) return true;
  std::cerr << "tumble: --strict: nothing is judged\n";
  return false;
}

int sandbox(const Course& course) {
  const std::vector<MissingLayer> missing = missing_walls(course);
  for (const Layer layer : {Layer::limits, Layer::other_user, Layer::files, Layer::system_calls}) {
    std::string why;
    for (const MissingLayer& each : missing)
      if (each.layer == layer) why = each.why;
    std::cout << (why.empty() ? "stands   " : "missing  ") << name_of(layer)
              << (why.empty() ? "" : ": " + why) << "\n";
  }
  return missing.empty() ? 0 : 1;
}

}  // namespace tumble::judge
