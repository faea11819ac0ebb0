#include "judge/commands/grading_module.hpp"

#include <stdexcept>

#include "support/module.hpp"

namespace tumble::judge {

const GradingModule& grading_module(const Course& course) {
  if (!fs::exists(course.grading))
    throw std::runtime_error(
        "the part that grades classes is not built: build the target tumble_judge_grading");
  static const support::Module module(course.grading);
  return module.symbol<const GradingModule>("tumble_grading_module");
}

}  // namespace tumble::judge
