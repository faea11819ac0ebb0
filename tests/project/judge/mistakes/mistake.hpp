#pragma once
/// @file
/// A real student's mistake, as tests/project/mistakes/ keeps it: a source file whose first line
/// says what the judge has to make of it.

#include <algorithm>
#include <string>
#include <vector>

#include "project/judge/attacks/submission.hpp"

namespace tumble::test {

struct Mistake {
  std::string unit;  ///< "04_quaternions/product"
  std::string name;  ///< of the file
  std::string text;
  std::vector<std::string> outcomes;  ///< any of them will do
  std::vector<std::string> names;     ///< that the judge gives with every seed
  std::vector<std::string> possible;  ///< names that are right too, and depend on the seed

  std::string path() const { return unit + "/" + name; }
  /// Is this name right?
  bool allows(const std::string& name_given) const {
    return std::count(names.begin(), names.end(), name_given) +
               std::count(possible.begin(), possible.end(), name_given) >
           0;
  }
};

/// @throws std::invalid_argument if its first two lines do not say what to expect, and what is
/// wrong
inline Mistake read_mistake(const fs::path& file) {
  const std::string key = "// expect: ", named = "named ", may_be = "may be named ";
  const fs::path folder = file.parent_path();
  Mistake mistake{(folder.parent_path().filename() / folder.filename()).string(),
                  file.stem().string(),
                  text_of(file),
                  {},
                  {},
                  {}};
  const std::vector<std::string> lines = lines_of(mistake.text);
  require(lines.size() > 2 && lines[0].starts_with(key), file.string(),
          " does not say what to expect: // expect: wrong");
  require(lines[1].starts_with("// "), file.string(), " does not say what is wrong: // …");
  for (const std::string& part : detail::alternatives(lines[0].substr(key.size()))) {
    if (part.starts_with(named))
      mistake.names.push_back(part.substr(named.size()));
    else if (part.starts_with(may_be))
      mistake.possible.push_back(part.substr(may_be.size()));
    else
      mistake.outcomes.push_back(part);
  }
  require(!mistake.outcomes.empty(), file.string(), " expects no outcome");
  return mistake;
}

/// All of them, by path.
inline std::vector<Mistake> all_mistakes() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(root() / "tests/project/mistakes"))
    if (entry.path().extension() == ".cpp") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Mistake> mistakes;
  for (const fs::path& file : files) mistakes.push_back(read_mistake(file));
  return mistakes;
}

}  // namespace tumble::test
