#include "judge/build/link_failure.hpp"

#include <algorithm>

#include "judge/build/diagnostics.hpp"
#include "judge/course/contract.hpp"

namespace tumble::judge {

namespace {

std::string found_instead(const std::vector<std::string>& functions) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, functions.size()); ++i)
    text += "  " + functions[i].substr(0, 200) + "\n";
  return text.empty() ? "" : "found there:\n" + text;
}

std::string text_about(const std::vector<std::string>& undefined) {
  std::string text = "Your code calls these functions, but nothing defines them:\n";
  for (const std::string& name : undefined) text += "  " + brief_name(name) + "\n";
  const bool of_eigen = undefined.front().find("Eigen::") != std::string::npos;
  return text +
         (of_eigen
              ? "(An exercise has Eigen/Core alone. cross(), inverse() and determinant() are in\n"
                "other headers of Eigen: write out what you need of them. For a × b you have 3.2:\n"
                "skew(a) * b in chapter 3, rotation_matrices::skew(a) * b from chapter 5 on.\n"
                "Chapter 4 has no skew: there you write the three components out.)\n"
              : "(A later exercise? A helper that is declared, but not defined?)\n");
}

}  // namespace

void explain_link_failure(BuildReport& report, const Course& course, const Unit& unit,
                          const std::string& linker_output,
                          const std::vector<std::string>& functions) {
  const std::vector<std::string> undefined = undefined_functions(linker_output);
  const bool absent = std::any_of(undefined.begin(), undefined.end(), [&](const auto& name) {
    return name.ends_with("::" + unit.name);
  });
  report.explained = !undefined.empty();
  report.involves_course = true;
  if (absent) {
    report.outcome = BuildOutcome::wrong_signature;
    report.detail = read_declaration(course, unit).signature + "\n" + found_instead(functions);
  } else if (!undefined.empty()) {
    report.detail = text_about(undefined);
  } else {  // names of functions, no text of a file
    report.detail = "linking fails:\n" + linker_output;
  }
}

}  // namespace tumble::judge
