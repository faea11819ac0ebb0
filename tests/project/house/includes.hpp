#pragma once
/// @file
/// The law of the house, read from the #includes: every arrow points down to lib/, nothing that
/// ships includes what does not, and no folders include each other in a circle.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tumble::house {

namespace fs = std::filesystem;

/// One `#include "…"` of a file.
struct Include {
  fs::path from;      ///< the file, from the root of the tree
  std::size_t line;   ///< where it stands
  std::string text;   ///< what stands between the quotes
  fs::path resolved;  ///< the file that is meant, from the root; empty if there is none
};

/// Every quoted include of the C++ files under lib/, chapters/, exercises/, solutions/ and tests/,
/// but for submissions that attack the judge and programs outside the project.
std::vector<Include> includes_of(const fs::path& root);

/// What is against the law, a sentence per include: "lib/a.hpp:3 includes tests/b.hpp: …".
std::vector<std::string> broken_laws(const std::vector<Include>& includes);

/// The folders that include each other in a circle, as "a → b → a"; empty if there are none.
/// Folders of tests/project/ do not count: nobody includes them.
std::vector<std::string> circles(const std::vector<Include>& includes);

}  // namespace tumble::house
