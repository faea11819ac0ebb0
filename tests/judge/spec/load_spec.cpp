#include "judge/spec/load_spec.hpp"

#include <map>
#include <mutex>
#include <stdexcept>

#include "support/module.hpp"

namespace tumble::judge {

namespace {

/// @throws std::runtime_error that says what to build
support::Module module_of(const Unit& unit) {
  const std::string name = unit.number + " " + unit.name;
  const std::string target = "spec." + unit.chapter + "." + unit.name;
  if (!fs::exists(unit.spec) || !fs::exists(unit.worker))
    throw std::runtime_error(name + " is not built yet: build the target " + target);
  try {
    return support::Module(unit.spec);
  } catch (const std::runtime_error& why) {
    // The mark of the headers is a name that a judge of the same headers has: see
    // header_mark.cmake.
    if (std::string(why.what()).find("tumble_spec_headers_") == std::string::npos) throw;
    throw std::runtime_error("the spec of " + name +
                             " was built with other headers than this judge: build the targets "
                             "tumble_judge and " +
                             target);
  }
}

}  // namespace

void load_spec(const Unit& unit) {
  if (unit.spec.empty()) return;
  static std::mutex mutex;
  static std::map<fs::path, support::Module> loaded;
  const std::lock_guard lock(mutex);
  if (!loaded.contains(unit.spec)) loaded.emplace(unit.spec, module_of(unit));
}

}  // namespace tumble::judge
