#include "judge/spec/load_spec.hpp"

#include <map>
#include <mutex>
#include <stdexcept>

#include "support/module.hpp"

namespace tumble::judge {

void load_spec(const Unit& unit) {
  if (unit.spec.empty()) return;
  static std::mutex mutex;
  static std::map<fs::path, support::Module> loaded;
  const std::lock_guard lock(mutex);
  if (loaded.contains(unit.spec)) return;
  for (const fs::path& file : {unit.spec, unit.worker})
    if (!fs::exists(file))
      throw std::runtime_error(unit.number + " " + unit.name +
                               " is not built yet: build the target spec." + unit.chapter + "." +
                               unit.name);
  loaded.emplace(unit.spec, support::Module(unit.spec));
}

}  // namespace tumble::judge
