#include "judge/build/build_outcome.hpp"

namespace tumble::judge {

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

}  // namespace tumble::judge
