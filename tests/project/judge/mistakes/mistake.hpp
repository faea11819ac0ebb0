#pragma once
/// @file
/// A real student's mistake, as tests/project/mistakes/ keeps it: what it changes in the solution
/// of its exercise, and what the judge has to make of that.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "project/judge/attacks/submission.hpp"

namespace tumble::test {

struct Mistake {
  std::string unit;                   ///< "04_quaternions/product"
  std::string name;                   ///< "never_set", one of the unit's
  std::string text;                   ///< what the student hands in
  std::vector<std::string> outcomes;  ///< any of them will do
  std::vector<std::string> names;     ///< that the judge gives with every seed
  std::vector<std::string> possible;  ///< names that are right too, and depend on the seed

  std::string path() const { return unit + "/" + name; }
  bool expects(const std::string& outcome) const {
    return std::count(outcomes.begin(), outcomes.end(), outcome) == 1;
  }
  /// Is this name right?
  bool allows(const std::string& name_given) const {
    return std::count(names.begin(), names.end(), name_given) +
               std::count(possible.begin(), possible.end(), name_given) >
           0;
  }
};

/// Reads the mistakes of one exercise. (README.md in tests/project/mistakes says how they look.)
class MistakesReader {
 public:
  /// @param file "…/04_quaternions/product.mistakes"
  explicit MistakesReader(const fs::path& file)
      : file_(file),
        unit_((file.parent_path().filename() / file.stem()).string()),
        solution_(text_of(root() / "solutions" / (unit_ + ".cpp"))),
        lines_(lines_of(text_of(file))) {}

  /// @throws std::invalid_argument if one does not say what to expect and what is wrong, or
  /// replaces lines that do not stand in the solution exactly once
  std::vector<Mistake> read() {
    std::vector<Mistake> mistakes;
    while (at_ < lines_.size()) {
      if (lines_[at_].empty())
        ++at_;
      else
        mistakes.push_back(next());
    }
    return mistakes;
  }

 private:
  template <class... Words>
  void require_here(bool holds, const Words&... words) const {
    require(holds, file_.string(), ":", at_ + 1, ": ", words...);
  }
  bool starts(char sign) const {
    return at_ < lines_.size() && !lines_[at_].empty() && lines_[at_].front() == sign;
  }
  /// What follows `key` in the line here, which is left behind.
  std::string after(const std::string& key, const char* what) {
    require_here(at_ < lines_.size() && lines_[at_].starts_with(key), "here should stand ", what);
    return lines_[at_++].substr(key.size());
  }

  Mistake next() {
    Mistake mistake{unit_, after("# ", "\"# name\""), solution_, {}, {}, {}};
    for (const std::string& part :
         detail::alternatives(after("expect: ", "what to expect, \"expect: wrong\"")))
      add_expectation(mistake, part);
    require_here(!mistake.outcomes.empty(), "no outcome is expected");
    require_here(!after("", "what is wrong, in a sentence").empty(), "nothing says what is wrong");
    require_here(starts('-'), "no line of the solution is replaced");
    while (starts('-')) replace_lines(mistake.text);
    return mistake;
  }

  static void add_expectation(Mistake& mistake, const std::string& part) {
    const std::string named = "named ", may_be = "may be named ";
    if (part.starts_with(named))
      mistake.names.push_back(part.substr(named.size()));
    else if (part.starts_with(may_be))
      mistake.possible.push_back(part.substr(may_be.size()));
    else
      mistake.outcomes.push_back(part);
  }

  /// The lines that begin with `sign` here, without it.
  std::string block(char sign) {
    std::string text;
    for (; starts(sign); ++at_) text += lines_[at_].substr(1) + "\n";
    return text;
  }

  void replace_lines(std::string& text) {
    const std::string whole = "\n" + text;  // so that each line begins after a line break
    const std::string before = "\n" + block('-'), after = "\n" + block('+');
    const auto found = whole.find(before);
    require_here(found != std::string::npos, "these lines do not stand in the solution:", before);
    require_here(whole.find(before, found + 1) == std::string::npos,
                 "these lines stand in the solution more than once:", before);
    text = std::string(whole).replace(found, before.size(), after).substr(1);
  }

  fs::path file_;
  std::string unit_, solution_;
  std::vector<std::string> lines_;
  std::size_t at_ = 0;
};

/// All of them, by path.
inline std::vector<Mistake> all_mistakes() {
  std::vector<Mistake> mistakes;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(root() / "tests/project/mistakes"))
    if (entry.path().extension() == ".mistakes")
      for (Mistake& each : MistakesReader(entry.path()).read()) mistakes.push_back(std::move(each));
  std::sort(mistakes.begin(), mistakes.end(),
            [](const Mistake& a, const Mistake& b) { return a.path() < b.path(); });
  return mistakes;
}

}  // namespace tumble::test
