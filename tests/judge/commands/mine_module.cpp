#include "judge/commands/mine_module.hpp"

#include <stdexcept>

#include "support/module.hpp"

namespace tumble::judge {

const MineModule& mine_module(const Course& course) {
  if (course.engine.empty())
    throw std::runtime_error(
        "an engine needs functions of every chapter, and this tree lacks some chapters");
  if (!fs::exists(course.mine))
    throw std::runtime_error(
        "the part that measures engines is not built: build the target tumble_judge_mine");
  static const support::Module module(course.mine);
  return module.symbol<const MineModule>("tumble_mine_module");
}

int mine_command(const Course& course, const MineOptions& options) {
  return mine_module(course).command(course, options);
}

}  // namespace tumble::judge
