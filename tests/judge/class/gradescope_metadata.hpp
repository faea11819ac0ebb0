#pragma once
/// @file
/// Who has handed in what, as Gradescope's export says it in submission_metadata.yml:
///
///     submission_1001:
///       :submitters:
///       - :name: Jane Doe
///         :sid: '12345'
///         :email: jane@example.edu
///       :created_at: 2026-11-12 22:43:59.184049000 Z

#include <map>
#include <string>
#include <vector>

#include "judge/class/submissions.hpp"

namespace tumble::judge {

struct GradescopeSubmission {
  std::vector<Identity> submitters;  ///< a group hands in together
  std::string created_at;
};

/// Of each folder. What the file says besides, results and earlier submissions, is not looked at.
/// @throws std::invalid_argument if the text is of another kind
std::map<std::string, GradescopeSubmission> read_gradescope_metadata(const std::string& text);

}  // namespace tumble::judge
