#include "judge/commands/needs.hpp"

namespace tumble::judge {

Targets specs_of(const std::vector<Unit>& units) {
  Targets targets;
  for (const Unit& unit : units) targets.push_back("spec." + unit.chapter + "." + unit.name);
  return targets;
}

Targets all_specs() { return {"all_specs"}; }

}  // namespace tumble::judge
