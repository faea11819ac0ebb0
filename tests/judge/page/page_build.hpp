#pragma once
/// @file
/// What the page's compiler says of a student's file, as the native build would report it.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "judge/build/build_outcome.hpp"
#include "judge/course/course.hpp"

namespace tumble::judge {

/// What came back from site/compiler.mjs.
struct PageBuild {
  bool ok = false;
  std::string
      step;  ///< the last one: "compile", "link"; "limit" if it took too much of time or memory
  std::string output;                  ///< what compiler and linker have printed
  std::vector<std::string> headers;    ///< what the file includes and an exercise may not see
  std::vector<std::string> functions;  ///< what it defines; empty if that is not known
};

/// @throws nlohmann::json::exception if something is missing or of another type
PageBuild page_build_of(const nlohmann::json& json);

/// @param source the text that was compiled, as "/student/product.cpp" for 4.1 product
BuildReport report_of(const PageBuild& build, const Course& course, const Unit& unit,
                      const std::string& source);

}  // namespace tumble::judge
