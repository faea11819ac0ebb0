/// @file
/// A system without Landlock: no rules, and missing_walls() says so.
#include "judge/sandbox/open_files.hpp"

namespace tumble::judge {

bool file_rules_available() { return false; }
FileRules::FileRules(const OpenFiles&) {}
FileRules::~FileRules() = default;
bool FileRules::install() const { return true; }

}  // namespace tumble::judge
